#include <gtest/gtest.h>

#include "admissibility/sample_gap.hpp"
#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/tighten_displacement.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{
namespace
{

/// A strip with a displacement that penetrates here and opens there, a stress d = K eps(w) and the pressure 1.
struct Scene
{
  Scene(int order, double bend, bool turns)
      : strip(turns ? test::turningStrip(4, order, bend) : test::contactStrip(4, order, bend))
  {
    const Vector pressure(std::size_t(4 * order + 1), -1.0);
    traction = tractionFromNodes(strip.patches, pressure, order, 2);
    gap = boundGap(strip.bodyPointers(), strip.patches, 2, test::Gap("0.02*x").on(strip));
    test::Random random(3);
    for (std::size_t b = 0; b < 2; ++b) {
      const BodyModel& body = strip.bodies[b];
      systems.push_back(test::assemble(body, Comm::single()));
      displacement.push_back(atNodes(random.vector(std::size_t(body.numDofs())), 2));
      Vector w = random.vector(std::size_t(body.numDofs()));
      for (std::size_t i = 0; i < w.size(); ++i) {
        displacement[b][i] *= 0.02;
        w[i] *= 0.01;
      }
      bound.residual.push_back(atNodes(stiff(b, w), 2));
      bound.traction.push_back(atNodes(contactForces(body, int(b), strip.patches, {traction, traction}), 2));
      bound.distance += dot(w, bound.residual[b]);
    }
    bound.distance = std::sqrt(bound.distance);
    bound.contact = contactWork(displacement);
  }

  Vector stiff(std::size_t body, const Vector& field) const
  {
    const BodySystem& system = systems[body];
    return system.dofs.frames.toGlobal(multiply(system.K, system.dofs.frames.toLocal(field), Comm::single()));
  }

  /// int t^ (w - g).
  double contactWork(const std::vector<NodalField>& field) const
  {
    Vector opening = jumpMoments(strip.bodyPointers(), strip.patches, field, 2);
    for (std::size_t i = 0; i < opening.size(); ++i)
      opening[i] -= gap.moments[i];
    double twice = 0.0;
    for (const double work : contactContributions(strip.patches, traction, opening))
      twice += work;
    return 0.5 * twice;
  }

  /// A + R, by the assembled matrices.
  double boundWith(const std::vector<NodalField>& admissible) const
  {
    double residual = 0.0, square = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
      Vector v = admissible[b];
      for (std::size_t i = 0; i < v.size(); ++i)
        v[i] -= displacement[b][i];
      residual += dot(v, bound.residual[b]);
      square += dot(v, stiff(b, v));
    }
    const double A2 = bound.distance * bound.distance + 2.0 * residual + square;
    const double R2 = bound.distance * bound.distance - 2.0 * residual + square + 4.0 * contactWork(admissible);
    return 0.5 * (std::sqrt(A2) + std::sqrt(R2));
  }

  AdmissibleDisplacement admit() const
  {
    return admitDisplacement(strip.bodyPointers(), strip.constraintPointers(), strip.patches, gap, displacement);
  }

  void tighten(AdmissibleDisplacement& admissible) const
  {
    tightenDisplacement(strip.bodyPointers(), strip.constraintPointers(), strip.patches, gap, displacement, bound,
                        admissible);
  }

  test::ContactStrip strip;
  std::vector<BodySystem> systems;
  std::vector<NodalField> displacement;
  ContactTraction traction;
  GapBound gap;
  BoundOfDisplacement bound;
};

double deepest(const Scene& scene, const std::vector<NodalField>& displacement)
{
  double depth = -HUGE_VAL;
  for (std::size_t f = 0; f < scene.strip.patches.size(); ++f)
    for (int i = 0; i <= 100; ++i)
      depth = std::max(depth, scene.strip.jump(displacement, f, i / 100.0) - 0.02 * scene.strip.point(f, i / 100.0)[0]);
  return depth;
}

} // namespace

struct Tightening : testing::TestWithParam<test::Strip>
{
  Scene scene{GetParam().order, GetParam().bend, GetParam().turns};
};
INSTANTIATE_TEST_SUITE_P(Strips, Tightening, testing::ValuesIn(test::strips),
                         [](const auto& strip) { return nameOf(strip.param); });

TEST_P(Tightening, LowersTheBoundAndStaysBelowTheGap)
{
  AdmissibleDisplacement admissible = scene.admit();
  const double nearest = scene.boundWith(admissible.displacement);
  scene.tighten(admissible);
  EXPECT_LT(scene.boundWith(admissible.displacement), 0.99 * nearest);
  EXPECT_LE(deepest(scene, admissible.displacement), 1e-15);
}

TEST_P(Tightening, FindsNothingMoreWhenItIsRepeated)
{
  AdmissibleDisplacement admissible = scene.admit();
  scene.tighten(admissible);
  const double first = scene.boundWith(admissible.displacement);
  scene.tighten(admissible);
  EXPECT_LE(scene.boundWith(admissible.displacement), first * (1.0 + 1e-14));
  EXPECT_GT(scene.boundWith(admissible.displacement), 0.99 * first);
}

TEST_P(Tightening, ReportsTheDistanceFromTheSolvedDisplacement)
{
  AdmissibleDisplacement admissible = scene.admit();
  scene.tighten(admissible);
  double square = 0.0;
  for (std::size_t b = 0; b < 2; ++b) {
    Vector v = admissible.displacement[b];
    for (std::size_t i = 0; i < v.size(); ++i)
      v[i] -= scene.displacement[b][i];
    square += dot(v, scene.stiff(b, v));
  }
  EXPECT_NEAR(admissible.charge, std::sqrt(square), 1e-12 * admissible.charge);
}

} // namespace ndframe
