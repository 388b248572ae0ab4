// What an engineer checks first: reactions, extremes, and the forces on every body in equilibrium.

#include <cmath>

#include <gtest/gtest.h>

#include "driver/scene.hpp"
#include "ndframe/condensation/reactions.hpp"
#include "ndframe/run/interface_chains.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

const Comm& alone()
{
  static const Comm comm = Comm::single();
  return comm;
}

/// Force and moment (about the origin), in one vector.
using Wrench = Vector;

void add(Wrench& sum, const Direction& arm, const Direction& force, int dim)
{
  for (std::size_t k = 0; k < std::size_t(dim); ++k)
    sum[k] += force[k];
  const auto moment = momentOf(arm, force, dim);
  for (std::size_t k = 0; k < moment.size(); ++k)
    sum[std::size_t(dim) + k] += moment[k];
}

Direction vectorOf(const double* values, std::size_t dim)
{
  Direction result{};
  std::copy_n(values, dim, result.begin());
  return result;
}

Wrench zero(int dim)
{
  return Wrench(dim == 2 ? 3 : 6, 0.0);
}

/// Of nodal forces.
Wrench wrenchOf(const NodeMap& nodes, const Vector& forces)
{
  Wrench sum = zero(nodes.dim);
  for (int i = 0; i < nodes.numNodes(); ++i)
    add(sum, vectorOf(nodes.point(i).data(), std::size_t(nodes.dim)),
        vectorOf(forces.data() + std::ptrdiff_t(i) * nodes.dim, std::size_t(nodes.dim)), nodes.dim);
  return sum;
}

/// Of what the summary says of a body's supports.
Wrench wrenchOf(const std::vector<SupportSummary>& supports, int dim)
{
  Wrench sum = zero(dim);
  for (const auto& support : supports) {
    add(sum, vectorOf(support.centre.data(), std::size_t(dim)), vectorOf(support.force.data(), std::size_t(dim)), dim);
    for (std::size_t k = 0; k < support.moment.size(); ++k)
      sum[std::size_t(dim) + k] += support.moment[k];
  }
  return sum;
}

/// Sum of |F_i| (1 + |x_i|): what round-off of a wrench is relative to.
double scaleOf(const NodeMap& nodes, const Vector& forces)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto x = nodes.point(int(i) / nodes.dim);
    sum += std::abs(forces[i]) * (1.0 + std::hypot(x[0], x[1], nodes.dim == 3 ? x[2] : 0.0));
  }
  return sum;
}

Scene sceneOf(const std::string& name)
{
  return name.find('/') == std::string::npos ? Scene(name) : Scene::fromFile(NDFRAME_DECKS "/../" + name + ".xml");
}

class Equilibrium : public testing::TestWithParam<const char*>
{};

} // namespace

TEST_P(Equilibrium, OfLoadsReactionsAndContactOnEveryBody)
{
  const Outcome outcome = sceneOf(GetParam()).run();
  const ndframe::Run& run = outcome.run;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const Vector contact = contactForces(run.model, run.condensed, run.solved.coupling.state, int(b));
    const Wrench loads = wrenchOf(body.nodes, run.model.loads[b].all()), pressed = wrenchOf(body.nodes, contact);
    const Wrench held = wrenchOf(run.summary.bodies[b].supports, body.mesh.dim);
    const Vector reactions =
        supportForces(run.model, run.condensed, run.solved.coupling.state, int(b), run.solved.fields[b]);
    const double scale =
        scaleOf(body.nodes, run.model.loads[b].all()) + scaleOf(body.nodes, contact) + scaleOf(body.nodes, reactions);
    ASSERT_GT(scale, 0.0) << body.name;
    for (std::size_t k = 0; k < held.size(); ++k)
      EXPECT_NEAR(loads[k] + pressed[k] + held[k], 0.0, 1e-11 * scale) << body.name << ", component " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Equilibrium,
                         testing::Values("punch", "contact-loss", "hertz", "patch", "rings", "beam-3d",
                                         "regression/cases/inclined/inclined",
                                         "regression/cases/three-bodies/three-bodies",
                                         "regression/cases/body-force/body-force",
                                         "regression/cases/prescribed-displacement/prescribed-displacement"));

TEST(Reactions, DoNotDependOnTheOrientation)
{
  const Outcome straight = Scene("contact-loss").run(), turned = Scene("contact-loss").rotate(37.0).run();
  const double c = std::cos(37.0 * M_PI / 180.0), s = std::sin(37.0 * M_PI / 180.0);
  for (std::size_t b = 0; b < straight.run.summary.bodies.size(); ++b) {
    const BodySummary &first = straight.run.summary.bodies[b], &second = turned.run.summary.bodies[b];
    ASSERT_EQ(first.supports.size(), second.supports.size());
    for (std::size_t i = 0; i < first.supports.size(); ++i) {
      const auto &p = first.supports[i], &q = second.supports[i];
      EXPECT_NEAR(c * p.force[0] - s * p.force[1], q.force[0], 1e-9);
      EXPECT_NEAR(s * p.force[0] + c * p.force[1], q.force[1], 1e-9);
      EXPECT_NEAR(p.moment[0], q.moment[0], 1e-9);
      EXPECT_NEAR(c * p.centre[0] - s * p.centre[1], q.centre[0], 1e-12);
    }
    EXPECT_NEAR(first.displacement.value / second.displacement.value, 1.0, 1e-9);
    EXPECT_NEAR(first.strain.value / second.strain.value, 1.0, 1e-9);
  }
}

TEST(Reactions, FollowTheUnits)
{
  const double length = 1e3, stress = 2.1e-5;
  const Outcome first = Scene("contact-loss").run(), second = Scene("contact-loss").changeUnits(length, stress).run();
  for (std::size_t b = 0; b < first.run.summary.bodies.size(); ++b) {
    const BodySummary &p = first.run.summary.bodies[b], &q = second.run.summary.bodies[b];
    for (std::size_t i = 0; i < p.supports.size(); ++i) {
      EXPECT_NEAR(p.supports[i].force[1], q.supports[i].force[1] / (stress * length), 1e-9);
      EXPECT_NEAR(p.supports[i].moment[0], q.supports[i].moment[0] / (stress * length * length), 1e-9);
    }
    EXPECT_NEAR(q.displacement.value / (p.displacement.value * length), 1.0, 1e-9);
    EXPECT_NEAR(q.strain.value / p.strain.value, 1.0, 1e-9);
  }
}

TEST(Reactions, OfTwoSupportsAddUpToThoseOfOne)
{
  // A corner that both hold: the clamp's second direction is its own, the first is shared.
  const Outcome both = Scene("punch").run();
  const Outcome twice = Scene("punch")
                            .set("Bodies/foundation/Supports/again/Type=Clamp")
                            .set("Bodies/foundation/Supports/again/Side=bottom")
                            .run();
  const auto &one = both.run.summary.bodies[1].supports, &two = twice.run.summary.bodies[1].supports;
  ASSERT_EQ(two.size(), 3U);
  EXPECT_EQ(two[2].description, "clamp at bottom");
  EXPECT_NEAR(two[0].force[1], 0.5 * one[0].force[1], 1e-12);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(two[0].force[k] + two[1].force[k] + two[2].force[k], one[0].force[k] + one[1].force[k], 1e-12);
}

TEST(Extremes, OfThePatchAreThoseOfTheClosedForm)
{
  const Outcome outcome = Scene("patch").set("Coupling/Type=Monolithic").run();
  const BodySummary& upper = outcome.run.summary.bodies[0];
  // u = (0.39 x, -0.455 - 0.91 y) on the unit square, e_yy = -0.91
  EXPECT_NEAR(upper.displacement.value, std::hypot(0.39, 1.365), 1e-9);
  EXPECT_EQ(upper.displacement.point, (std::vector<double>{1.0, 1.0}));
  EXPECT_NEAR(upper.strain.value, 0.91, 1e-9);
  EXPECT_NEAR(upper.loadForce[1], -1.0, 1e-12);
}

TEST(ContactPressure, IsZeroAtOpenNodesAndCarriesTheForce)
{
  for (const char* name : {"contact-loss", "hertz", "regression/cases/three-bodies/three-bodies"}) {
    const Outcome outcome = sceneOf(name).run();
    const ndframe::Run& run = outcome.run;
    const Vector share = run.condensed.interface.C->apply(Vector(run.solved.contact.size(), 1.0));
    double resultant = 0.0, force = 0.0;
    for (std::size_t i = 0; i < run.solved.contact.size(); ++i) {
      const ContactNode& node = run.solved.contact[i];
      EXPECT_GE(node.pressure, 0.0);
      EXPECT_TRUE(node.closed || node.pressure == 0.0) << name << ", node " << i;
      resultant += share[i] * node.pressure;
    }
    for (const auto& interface : run.summary.interfaces)
      force += interface.contactForce;
    EXPECT_NEAR(resultant / force, 1.0, 1e-10) << name;
  }
}

TEST(ContactTable, IsSortedAlongTheSide)
{
  for (const char* name : {"contact-loss", "rings"}) {
    const Outcome outcome = Scene(name).run();
    const auto rows = sortedAlong(outcome.run.model.interfaces, outcome.run.solved.contact);
    ASSERT_EQ(rows.size(), outcome.run.solved.contact.size());
    EXPECT_EQ(rows.front().arcLength, 0.0);
    double total = 0.0;
    for (const double measure : outcome.run.model.interfaces[0].measures)
      total += measure;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double step = std::hypot(rows[i].point[0] - rows[i - 1].point[0], rows[i].point[1] - rows[i - 1].point[1]);
      EXPECT_NEAR(rows[i].arcLength - rows[i - 1].arcLength, step, 1e-12);
      EXPECT_LT(step, 2.0 * total / double(rows.size())) << name << ": neighbours follow each other";
    }
    EXPECT_NEAR(rows.back().arcLength, total, 1e-12 * total);
  }
}
