#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "admissibility/sample_gap.hpp"
#include "common/test_main.hpp"
#include "ndframe/admissibility/admissible_displacement.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{

namespace
{

using test::ContactStrip;
using test::Gap;

const Gap roundedGap = "0.01 + 0.02*exp(2*x)";

GapBound bound(const ContactStrip& strip, const Gap& gap)
{
  return boundGap(strip.bodyPointers(), strip.patches, 2, gap.on(strip));
}

AdmissibleDisplacement admit(const ContactStrip& strip, const Gap& gap, const std::vector<NodalField>& displacement)
{
  return admitDisplacement(strip.bodyPointers(), strip.constraintPointers(), strip.patches, bound(strip, gap),
                           displacement);
}

std::vector<NodalField> randomDisplacement(const ContactStrip& strip, unsigned seed, double size = 0.3)
{
  test::Random random(seed);
  std::vector<NodalField> all;
  for (const auto& body : strip.bodies) {
    all.push_back(atNodes(random.vector(std::size_t(body.numDofs())), body.mesh.dim));
    for (double& value : all.back())
      value *= size;
  }
  return all;
}

/// The largest jump - gap over many points of all facets.
double deepest(const ContactStrip& strip, const Gap& gap, const std::vector<NodalField>& displacement)
{
  double depth = -1e300;
  for (std::size_t f = 0; f < strip.patches.size(); ++f)
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0;
      depth = std::max(depth, strip.jump(displacement, f, t) - gap(strip.point(f, t)[0]));
    }
  return depth;
}

/// |u^ - u_h| by the assembled matrices.
double changeInEnergy(const ContactStrip& strip, const std::vector<NodalField>& from, const std::vector<NodalField>& to)
{
  double square = 0.0;
  for (std::size_t b = 0; b < 2; ++b) {
    Vector change = to[b];
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] -= from[b][i];
    const BodySystem system = test::assemble(strip.bodies[b], Comm::single());
    const Vector local = system.dofs.frames.toLocal(change);
    square += dot(local, multiply(system.K, local, Comm::single()));
  }
  return std::sqrt(square);
}

test::Conditions supported(std::vector<test::Condition> supports)
{
  return {std::move(supports), {}};
}

} // namespace

struct Admission : testing::TestWithParam<test::Strip>
{
  ContactStrip strip = GetParam().turns ? test::turningStrip(4, GetParam().order, GetParam().bend)
                                        : test::contactStrip(4, GetParam().order, GetParam().bend);
};
INSTANTIATE_TEST_SUITE_P(Strips, Admission, testing::ValuesIn(test::strips),
                         [](const auto& strip) { return nameOf(strip.param); });

TEST_P(Admission, MakesTheJumpStayBelowTheGapEverywhere)
{
  for (unsigned seed = 0; seed < 5; ++seed)
    for (const Gap& gap : {roundedGap, Gap("0")}) {
      const auto before = randomDisplacement(strip, seed);
      const AdmissibleDisplacement after = admit(strip, gap, before);
      EXPECT_GT(deepest(strip, gap, before), 1e-2);
      EXPECT_LE(deepest(strip, gap, after.displacement), 1e-15);
      EXPECT_EQ(after.caveat, "");
      EXPECT_GT(after.moved, 0);
    }
}

TEST_P(Admission, LeavesAdmissibleDisplacementsAlone)
{
  auto open = randomDisplacement(strip, 1, 1e-3);
  const AdmissibleDisplacement result = admit(strip, roundedGap, open);
  EXPECT_EQ(result.displacement, open);
  EXPECT_EQ(result.moved, 0);
  EXPECT_EQ(result.charge, 0.0);

  const AdmissibleDisplacement once = admit(strip, roundedGap, randomDisplacement(strip, 2)),
                               twice = admit(strip, roundedGap, once.displacement);
  EXPECT_EQ(twice.moved, 0);
}

TEST_P(Admission, ChargesTheEnergyOfTheChange)
{
  const auto before = randomDisplacement(strip, 3);
  const AdmissibleDisplacement after = admit(strip, roundedGap, before);
  EXPECT_NEAR(after.charge, changeInEnergy(strip, before, after.displacement), 1e-13 * after.charge);
}

TEST_P(Admission, MovesInterfaceNodesOnly)
{
  const auto before = randomDisplacement(strip, 4);
  const AdmissibleDisplacement after = admit(strip, roundedGap, before);
  int moved = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    std::set<int> interface;
    for (const auto& patch : strip.patches) {
      const auto nodes = contactNodes(strip.bodies[b], patch.sides[b]);
      interface.insert(nodes.begin(), nodes.begin() + GetParam().order + 1);
    }
    for (int node = 0; node < strip.bodies[b].nodes.numNodes(); ++node) {
      const auto at = std::size_t(node * 2);
      const bool isMoved =
          before[b][at] != after.displacement[b][at] || before[b][at + 1] != after.displacement[b][at + 1];
      EXPECT_TRUE(!isMoved || interface.count(node) > 0);
      moved += b == 0 && isMoved;
    }
  }
  EXPECT_EQ(moved, after.moved);
}

TEST_P(Admission, DoesNotDependOnUnits)
{
  const auto before = randomDisplacement(strip, 5);
  auto tiny = before;
  for (auto& body : tiny)
    for (double& value : body)
      value *= 1e-12;
  const AdmissibleDisplacement here = admit(strip, roundedGap, before),
                               there = admit(strip, "1e-12*(0.01 + 0.02*exp(2*x))", tiny);
  EXPECT_EQ(here.moved, there.moved);
  EXPECT_NEAR(there.charge, 1e-12 * here.charge, 1e-24 * here.charge);
}

TEST(AdmissionBetweenSupports, KeepsWhatTheyPrescribe)
{
  const auto rollers = supported({test::onSide("Roller", "left"), test::onSide("Clamp", "right")});
  const ContactStrip strip = test::contactStrip(4, 2, 0.3, rollers, supported({test::onSide("Roller", "left")}));
  const auto before = randomDisplacement(strip, 1);
  const AdmissibleDisplacement after = admit(strip, roundedGap, before);
  EXPECT_LE(deepest(strip, roundedGap, after.displacement), 1e-15);
  for (std::size_t b = 0; b < 2; ++b)
    for (const auto& [node, held] : strip.constraints[b].nodes())
      for (std::size_t k = 0; k < std::size_t(held.count); ++k) {
        double moved = 0.0;
        for (std::size_t i = 0; i < 2; ++i)
          moved += held.direction[k][i] *
                   (after.displacement[b][std::size_t(node) * 2 + i] - before[b][std::size_t(node) * 2 + i]);
        EXPECT_NEAR(moved, 0.0, 1e-16);
      }
}

TEST(AdmissionBetweenSupports, MovesTheOtherBodyWhereOneIsHeld)
{
  const ContactStrip strip = test::contactStrip(4, 2, 0.0, supported({test::onSide("Clamp", "bottom")}));
  const auto before = randomDisplacement(strip, 2);
  const AdmissibleDisplacement after = admit(strip, roundedGap, before);
  EXPECT_EQ(after.displacement[0], before[0]);
  EXPECT_LE(deepest(strip, roundedGap, after.displacement), 1e-15);
  EXPECT_EQ(after.caveat, "");
}

TEST(AdmissionBetweenSupports, SaysWhereBothBodiesAreHeld)
{
  const ContactStrip strip = test::contactStrip(2, 1, 0.0, supported({test::onSide("Clamp", "bottom")}),
                                                supported({test::onSide("Roller", "top")}));
  const AdmissibleDisplacement after = admit(strip, roundedGap, randomDisplacement(strip, 2));
  EXPECT_THAT(after.caveat, testing::AllOf(testing::HasSubstr("upper and lower overlap by"),
                                           testing::HasSubstr("where supports hold both")));
}

TEST(AdmissionByStiffness, MovesTheSofterBodyMore)
{
  const ContactStrip strip = test::contactStrip(4, 2);
  std::vector<NodalField> closed;
  for (const auto& body : strip.bodies)
    closed.emplace_back(IndexMap::whole(body.nodes.numNodes()), body.mesh.dim);
  const AdmissibleDisplacement after = admit(strip, "-0.1", closed);
  for (std::size_t f = 0; f < strip.patches.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const double up = strip.at(after.displacement, f, i, true)[1],
                   down = strip.at(after.displacement, f, i, false)[1];
      EXPECT_GE(up, 0.0);
      EXPECT_LE(down, 0.0);
      EXPECT_LE(up, -down);
    }
}

} // namespace ndframe
