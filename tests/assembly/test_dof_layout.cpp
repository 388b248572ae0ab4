#include <algorithm>
#include <cmath>

#include <random>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"

namespace ndframe
{

namespace
{

constexpr double degree = M_PI / 180.0;

Vector prescribedOf(const DofLayout& layout)
{
  Vector u(layout.roles.size(), 0.0);
  layout.addPrescribed(u);
  return u;
}

/// A vector of the nodes' own axes with the fixed dofs at their values and the others random.
Vector admissible(const DofLayout& layout, unsigned seed)
{
  const Vector prescribed = prescribedOf(layout);
  Vector u = test::Random(seed).vector(layout.roles.size());
  for (std::size_t dof = 0; dof < u.size(); ++dof)
    if (layout.roles[dof] == DofRole::Fixed)
      u[dof] = prescribed[dof];
  return u;
}

double along(const Vector& global, int node, int dim, const Direction& direction)
{
  double sum = 0.0;
  for (int k = 0; k < dim; ++k)
    sum += global[std::size_t(node * dim + k)] * direction[std::size_t(k)];
  return sum;
}

template <class Value>
double sumOf(const SparseRow& row, const Value& value)
{
  double sum = 0.0;
  for (const auto& [place, share] : row)
    sum += share * value(place);
  return sum;
}

/// u_N = scale s + others s' + offset and u . d = value, on random vectors.
void expectIdentities(const DofLayout& layout, const NodeMap& nodes, const ConstraintSet& constraints,
                      const std::vector<TraceNormal>& traces)
{
  ASSERT_EQ(layout.trace.size(), traces.size());
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Vector local = admissible(layout, seed), global = layout.frames.toGlobal(local);
    for (std::size_t i = 0; i < traces.size(); ++i) {
      const TraceDof& t = layout.trace[i];
      EXPECT_EQ(layout.roles[std::size_t(t.dof)], DofRole::Kept);
      EXPECT_NEAR(
          along(global, traces[i].node, nodes.dim, traces[i].normal),
          t.scale * local[std::size_t(t.dof)] + t.offset +
              sumOf(t.others, [&](int place) { return local[std::size_t(layout.trace[std::size_t(place)].dof)]; }),
          1e-14);
    }
    for (const auto& [node, fixed] : constraints.nodes())
      for (std::size_t k = 0; k < std::size_t(fixed.count); ++k)
        EXPECT_NEAR(along(global, node, nodes.dim, fixed.direction[k]), fixed.value[k], 1e-14);
  }
}

int count(const DofLayout& layout, DofRole role)
{
  return int(std::count(layout.roles.begin(), layout.roles.end(), role));
}

Direction inPlane(double angle)
{
  return {std::cos(angle), std::sin(angle), 0.0};
}

} // namespace

TEST(DofLayout, SupportsAlongTheAxesTurnNothing)
{
  auto support = test::onSide("Displacement", "right");
  support.entries.emplace_back("Y", "0.1*y");
  const BodyModel body = test::makeBody(test::box({3, 2}), 2, {{test::onSide("Roller", "left"), support}, {}});
  const ConstraintSet constraints = test::constraintsOf(body);
  const DofLayout layout = makeDofLayout(body.nodes, constraints, {});
  EXPECT_FALSE(layout.frames.anyTurned());
  EXPECT_EQ(count(layout, DofRole::Fixed), 10);
  EXPECT_EQ(count(layout, DofRole::Kept), 0);
  const Vector prescribed = prescribedOf(layout);
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    const auto x = body.nodes.point(node);
    const auto dof = std::size_t(2 * node);
    EXPECT_EQ(layout.roles[dof] == DofRole::Fixed, x[0] == 0.0);
    EXPECT_EQ(layout.roles[dof + 1] == DofRole::Fixed, x[0] == 1.0);
    EXPECT_EQ(prescribed[dof + 1], x[0] == 1.0 ? 0.1 * x[1] : 0.0);
  }
}

TEST(DofLayout, InclinedSupportsAreDofsInTurnedAxes)
{
  for (const int dim : {2, 3}) {
    const Mesh mesh = test::box(std::vector<int>(std::size_t(dim), 2), "Right", 35.0);
    const BodyModel body =
        test::makeBody(mesh, 2, {{test::onSide("Roller", "left"), test::onSide("Roller", "bottom")}, {}});
    const ConstraintSet constraints = test::constraintsOf(body);
    const DofLayout layout = makeDofLayout(body.nodes, constraints, {});
    EXPECT_TRUE(layout.frames.anyTurned());
    int held = 0;
    for (const auto& entry : constraints.nodes())
      held += entry.second.count;
    EXPECT_EQ(count(layout, DofRole::Fixed), held);
    expectIdentities(layout, body.nodes, constraints, {});
  }
}

TEST(DofLayout, ToLocalAndToGlobalAreInverseAndKeepLengths)
{
  for (const int dim : {2, 3}) {
    const Mesh mesh = test::box(std::vector<int>(std::size_t(dim), 2), "Right", 35.0);
    const BodyModel body = test::makeBody(mesh, 1, {{test::onSide("Roller", "left")}, {}});
    const DofLayout layout = makeDofLayout(body.nodes, test::constraintsOf(body), {});
    const Vector u = test::Random(4).vector(layout.roles.size());
    const Vector there = layout.frames.toLocal(layout.frames.toGlobal(u)),
                 back = layout.frames.toGlobal(layout.frames.toLocal(u));
    for (std::size_t i = 0; i < u.size(); ++i) {
      EXPECT_NEAR(there[i], u[i], 1e-15);
      EXPECT_NEAR(back[i], u[i], 1e-15);
    }
    EXPECT_NEAR(norm(layout.frames.toGlobal(u)), norm(u), 1e-14 * norm(u));
    EXPECT_NE(layout.frames.toGlobal(u).whole(), u);
  }
}

TEST(DofLayout, TraceNormalsAlongAnAxisKeepThatDofWithItsSign)
{
  const BodyModel body = test::makeBody(test::box({2, 1}), 1);
  const std::vector<TraceNormal> traces = {{5, {0, -1, 0}}, {3, {1, 0, 0}}};
  const DofLayout layout = makeDofLayout(body.nodes, test::constraintsOf(body), traces);
  EXPECT_FALSE(layout.frames.anyTurned());
  EXPECT_EQ(layout.keptDofs(), (std::vector<int>{11, 6}));
  EXPECT_EQ(layout.trace[0].scale, -1.0);
  EXPECT_EQ(layout.trace[1].scale, 1.0);
  EXPECT_EQ(layout.trace[0].offset, 0.0);
  expectIdentities(layout, body.nodes, test::constraintsOf(body), traces);
}

TEST(DofLayout, TraceNormalsThatDoNotLieOnAnAxisAreKeptExactly)
{
  const BodyModel body = test::makeBody(test::box({2, 1}), 1);
  for (const double angle : {1.0, 1e-3, 1e-8, 90 * degree + 1e-8}) {
    const std::vector<TraceNormal> traces = {{0, inPlane(angle)}, {4, inPlane(angle + 2.0)}};
    const DofLayout layout = makeDofLayout(body.nodes, test::constraintsOf(body), traces);
    EXPECT_EQ(layout.trace[0].scale, 1.0);
    expectIdentities(layout, body.nodes, test::constraintsOf(body), traces);
  }
}

TEST(DofLayout, ATraceNormalObliqueToASupportScalesTheFreeDisplacement)
{
  for (const int dim : {2, 3}) {
    const BodyModel body = test::makeBody(test::box(std::vector<int>(std::size_t(dim), 1)), 2);
    ConstraintSet constraints(dim, 1.0);
    constraints.add({1, inPlane(20 * degree), 0.3});
    constraints.add({2, {1, 0, 0}, -0.2});
    const std::vector<TraceNormal> traces = {{1, inPlane(80 * degree)}, {2, inPlane(-30 * degree)}};
    const DofLayout layout = makeDofLayout(body.nodes, constraints, traces);
    EXPECT_NEAR(layout.trace[0].scale, std::sin(60 * degree), 1e-14);
    EXPECT_NEAR(layout.trace[0].offset, 0.3 * std::cos(60 * degree), 1e-14);
    EXPECT_NEAR(std::abs(layout.trace[1].scale), std::sin(30 * degree), 1e-14);
    EXPECT_NEAR(layout.trace[1].offset, -0.2 * std::cos(30 * degree), 1e-14);
    expectIdentities(layout, body.nodes, constraints, traces);
  }
}

TEST(DofLayout, ATraceBetweenTwoSupportsInSpaceKeepsTheLastDirection)
{
  const BodyModel body = test::makeBody(test::box({1, 1, 1}), 1);
  ConstraintSet constraints(3, 1.0);
  constraints.add({0, inPlane(20 * degree), 0.3});
  constraints.add({0, {0, 0, 1}, 0.1});
  const std::vector<TraceNormal> traces = {{0, {0.48, 0.64, 0.6}}};
  const DofLayout layout = makeDofLayout(body.nodes, constraints, traces);
  EXPECT_EQ(count(layout, DofRole::Fixed), 2);
  EXPECT_EQ(count(layout, DofRole::Kept), 1);
  expectIdentities(layout, body.nodes, constraints, traces);
}

TEST(DofLayout, ANodeMayHaveTwoNormals)
{
  const BodyModel body = test::makeBody(test::box({2, 2}), 1);
  const ConstraintSet none(2, 1.0);
  for (const double first : {0.0, 30.0, 90.0, 200.0})
    for (const double turn : {36.0, 90.0, -120.0}) {
      const std::vector<TraceNormal> traces = {
          {1, inPlane(first * degree)}, {4, {0, -1, 0}}, {1, inPlane((first + turn) * degree)}};
      const DofLayout layout = makeDofLayout(body.nodes, none, traces);
      EXPECT_EQ(count(layout, DofRole::Kept), 3);
      EXPECT_EQ(layout.trace[2].others.front().first, 0);
      expectIdentities(layout, body.nodes, none, traces);
    }
}

/// Whatever normals meet at a node: the displacement along each is what its dofs, or the normals before, say.
TEST(DofLayout, AnyNumberOfNormalsMeetsAtANode)
{
  const BodyModel plane = test::makeBody(test::box({2, 2}), 2), space = test::makeBody(test::box({1, 1, 1}), 2);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 400; ++trial) {
    const BodyModel& body = trial % 2 == 0 ? plane : space;
    const int dim = body.mesh.dim;
    const auto direction = [&] {
      Direction d{};
      for (int k = 0; k < dim; ++k)
        d[std::size_t(k)] = number(random);
      const double length = std::sqrt(dotProduct(d, d));
      for (double& component : d)
        component /= length;
      return d;
    };
    ConstraintSet constraints(dim, 1.0);
    for (int k = 0; k < trial % 3 - (dim == 2 ? 1 : 0); ++k)
      constraints.add({4, direction(), 0.7});
    std::vector<TraceNormal> traces{{3, direction()}};
    for (int k = 0; k < 1 + trial % 5; ++k)
      traces.push_back({4, k == 2 && trial % 3 == 0 ? Direction{1, 0, 0} : direction()}); // one of them on an axis
    traces.push_back(traces.back());                                                      // and one twice
    const DofLayout layout = makeDofLayout(body.nodes, constraints, traces);
    ASSERT_EQ(layout.trace.size() + layout.dependents.size(), traces.size());
    Vector local = prescribedOf(layout);
    for (std::size_t i = 0; i < local.size(); ++i)
      if (layout.roles[i] != DofRole::Fixed)
        local[i] = number(random);
    const Vector u = layout.frames.toGlobal(local);
    std::vector<char> depends(traces.size(), 0);
    for (const DependentTrace& dependent : layout.dependents)
      depends[std::size_t(dependent.given)] = 1;
    Vector independent;
    for (std::size_t i = 0; i < traces.size(); ++i)
      if (!depends[i]) {
        const TraceDof& t = layout.trace[independent.size()];
        independent.push_back(along(u, traces[i].node, dim, traces[i].normal));
        const auto value = [&](int place) { return local[std::size_t(layout.trace[std::size_t(place)].dof)]; };
        EXPECT_NEAR(independent.back(), t.scale * local[std::size_t(t.dof)] + t.offset + sumOf(t.others, value), 1e-13);
      }
    for (const DependentTrace& dependent : layout.dependents) {
      const auto value = [&](int place) { return independent[std::size_t(place)]; };
      EXPECT_NEAR(along(u, traces[std::size_t(dependent.given)].node, dim, traces[std::size_t(dependent.given)].normal),
                  sumOf(dependent.row, value) + dependent.offset, 1e-7)
          << trial;
    }
  }
}

TEST(DofLayout, WrongTracesAreABug)
{
  const BodyModel body = test::makeBody(test::box({1, 1}), 1);
  ConstraintSet constraints(2, 1.0);
  constraints.add({0, {1, 0, 0}, 0.0});
  EXPECT_THROW(makeDofLayout(body.nodes, constraints, {{0, {-1, 0, 0}}}), InternalError);
}

} // namespace ndframe
