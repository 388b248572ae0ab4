#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"

namespace ndframe
{

namespace
{

using test::Condition;

Condition load(const std::string& type, std::vector<std::pair<std::string, std::string>> entries)
{
  return {type, std::move(entries)};
}

BodyModel loaded(const Mesh& mesh, int order, std::vector<Condition> loads)
{
  return test::makeBody(mesh, order, {{}, std::move(loads)});
}

Vector loadOf(const BodyModel& body)
{
  return assembleLoad(body, Frames(body.mesh.dim, body.nodes.numNodes()));
}

std::vector<double> placeOf(const BodyModel& body, int node)
{
  const auto x = body.nodes.point(node);
  return {x.begin(), x.begin() + body.mesh.dim};
}

Vector loadOf(const Mesh& mesh, int order, std::vector<Condition> loads)
{
  return loadOf(loaded(mesh, order, std::move(loads)));
}

/// sum_a f_a . u(x_a)
double work(const BodyModel& body, const Vector& f, const std::function<void(const double*, double*)>& field)
{
  return dot(f, test::interpolate(body.nodes, field));
}

/// Resultant force and moment about the origin: (F_x, F_y, F_z, M_x, M_y, M_z).
std::array<double, 6> resultant(const BodyModel& body)
{
  std::array<double, 6> sum{};
  const Vector load = loadOf(body);
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    double x[3] = {}, f[3] = {};
    for (int k = 0; k < body.mesh.dim; ++k) {
      x[k] = body.nodes.point(node)[k];
      f[k] = load[std::size_t(node * body.mesh.dim + k)];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += f[k];
      sum[3 + k] += x[(k + 1) % 3] * f[(k + 2) % 3] - x[(k + 2) % 3] * f[(k + 1) % 3];
    }
  }
  return sum;
}

void expectResultant(const BodyModel& body, const std::array<double, 6>& expected)
{
  const auto computed = resultant(body);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(computed[i], expected[i], 1e-13) << "component " << i;
}

/// 2 x 1 and 2 x 1 x 1.
Mesh plane()
{
  return test::shaken(test::box({5, 3}, "Alternating", 0.0, {2.0, 1.0}), 0.05, 3);
}
Mesh space()
{
  return test::shaken(test::box({3, 2, 2}, "Right", 0.0, {2.0, 1.0, 1.0}), 0.05, 3);
}

std::vector<Condition> pressureAllAround(const Mesh& mesh)
{
  std::vector<Condition> loads;
  for (const Side& side : mesh.sides)
    loads.push_back(load("Pressure", {{"Side", side.name}, {"Value", "3"}}));
  return loads;
}

} // namespace

struct Loads : testing::TestWithParam<int>
{
  int order = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Orders, Loads, testing::Values(1, 2), testing::PrintToStringParamName());

TEST_P(Loads, PressurePushesWithItsIntegralAndItsMoment)
{
  // int_0^2 x^2 dx = 8/3, int_0^2 x^3 dx = 4
  expectResultant(loaded(plane(), order, {load("Pressure", {{"Side", "top"}, {"Value", "x^2"}})}),
                  {0, -8.0 / 3.0, 0, 0, 0, -4});
  // int x^2 y = 4/3; M_x = -int y p = -8/9, M_y = int x p = 2
  expectResultant(loaded(space(), order, {load("Pressure", {{"Side", "top"}, {"Value", "x^2*y"}})}),
                  {0, 0, -4.0 / 3.0, -8.0 / 9.0, 2, 0});
}

TEST_P(Loads, ConstantPressureIsExactToo)
{
  expectResultant(loaded(plane(), order, {load("Pressure", {{"Side", "left"}, {"Value", "0.7"}})}),
                  {0.7, 0, 0, 0, 0, -0.35});
  expectResultant(loaded(space(), order, {load("Pressure", {{"Side", "left"}, {"Value", "0.7"}})}),
                  {0.7, 0, 0, 0, 0.35, -0.35});
}

TEST_P(Loads, TractionPullsWithItsIntegralAndItsMoment)
{
  expectResultant(loaded(plane(), order, {load("Traction", {{"Side", "right"}, {"X", "1"}, {"Y", "y^2 - 2"}})}),
                  {1, -5.0 / 3.0, 0, 0, 0, -10.0 / 3.0 - 0.5});
  expectResultant(loaded(space(), order, {load("Traction", {{"Side", "right"}, {"Z", "6*y*z"}})}),
                  {0, 0, 1.5, 1, -3, 0});
}

TEST_P(Loads, BodyForceActsWithItsIntegralAndItsMoment)
{
  // int x y = 1, int x^2 y = 4/3
  expectResultant(loaded(plane(), order, {load("Body Force", {{"Y", "x*y"}})}), {0, 1, 0, 0, 0, 4.0 / 3.0});
  expectResultant(loaded(space(), order, {load("Body Force", {{"X", "z"}, {"Y", "2"}})}),
                  {1, 4, 0, -2, 2.0 / 3.0, 3.5});
}

TEST_P(Loads, ExpressionsOfDegreeSixAreIntegratedExactlyAgainstTheElements)
{
  const BodyModel body = loaded(plane(), order, {load("Pressure", {{"Side", "top"}, {"Value", "x^6"}})});
  const int degree = order;
  const double computed = work(body, loadOf(body), [degree](const double* x, double* u) {
    u[0] = 0.0;
    u[1] = std::pow(x[0], degree);
  });
  const double exact = -std::pow(2.0, 7 + order) / (7 + order);
  EXPECT_NEAR(computed, exact, 1e-13 * std::abs(exact));
}

TEST_P(Loads, PressureOnAClosedBoundaryHasNoResultant)
{
  expectResultant(loaded(plane(), order, pressureAllAround(plane())), {});
  expectResultant(loaded(space(), order, pressureAllAround(space())), {});
}

TEST_P(Loads, PressureOnAClosedBoundaryWorksOnTheChangeOfVolume)
{
  // -p int div u, with div u = 1 for u = (x, 0, 0)
  for (const Mesh& mesh : {plane(), space()}) {
    const BodyModel body = loaded(mesh, order, pressureAllAround(mesh));
    const double computed = work(body, loadOf(body), [&mesh](const double* x, double* u) {
      std::fill_n(u, mesh.dim, 0.0);
      u[0] = x[0];
    });
    EXPECT_NEAR(computed, -6.0, 1e-13);
  }
}

TEST_P(Loads, SeveralAddUp)
{
  const auto first = load("Pressure", {{"Side", "top"}, {"Value", "x"}});
  const auto second = load("Body Force", {{"X", "y"}});
  const Vector one = loadOf(plane(), order, {first}), two = loadOf(plane(), order, {second}),
               both = loadOf(plane(), order, {first, second});
  for (std::size_t i = 0; i < both.size(); ++i)
    EXPECT_NEAR(both[i], one[i] + two[i], 1e-15);
}

TEST_P(Loads, DoNotDependOnTheNumbering)
{
  const std::vector<Condition> loads = {load("Pressure", {{"Side", "top"}, {"Value", "x*y"}}),
                                        load("Body Force", {{"X", "x + y"}})};
  for (const Mesh& mesh : {plane(), space()}) {
    const BodyModel body = loaded(mesh, order, loads), other = loaded(test::renumbered(mesh, 4), order, loads);
    const Vector f = loadOf(body), otherF = loadOf(other);
    std::map<std::vector<double>, int> nodeAt;
    for (int node = 0; node < body.nodes.numNodes(); ++node)
      nodeAt[placeOf(body, node)] = node;
    for (int node = 0; node < other.nodes.numNodes(); ++node) {
      const int same = nodeAt.at(placeOf(other, node));
      for (int k = 0; k < mesh.dim; ++k)
        EXPECT_NEAR(otherF[std::size_t(node * mesh.dim + k)], f[std::size_t(same * mesh.dim + k)], 1e-14);
    }
  }
}

TEST_P(Loads, PressureTurnsWithTheBody)
{
  const auto pressure = load("Pressure", {{"Side", "top"}, {"Value", "2"}});
  const BodyModel straight = loaded(test::box({4, 2}), order, {pressure});
  const BodyModel turned = loaded(test::box({4, 2}, "Right", 30.0), order, {pressure});
  const double c = std::cos(M_PI / 6.0), s = std::sin(M_PI / 6.0);
  const Vector f = loadOf(straight), turnedF = loadOf(turned);
  for (std::size_t i = 0; i < f.size(); i += 2) {
    EXPECT_NEAR(turnedF[i], c * f[i] - s * f[i + 1], 1e-14);
    EXPECT_NEAR(turnedF[i + 1], s * f[i] + c * f[i + 1], 1e-14);
  }
}

TEST_P(Loads, AreGivenInTheNodesOwnAxes)
{
  const BodyModel body = test::makeBody(
      test::box({4, 2}, "Right", 20.0), order,
      {{test::onSide("Roller", "bottom")}, {load("Traction", {{"Side", "bottom"}, {"X", "x"}, {"Y", "1"}})}});
  const DofLayout layout = makeDofLayout(body.nodes, test::constraintsOf(body), {});
  ASSERT_TRUE(layout.frames.anyTurned());
  const Vector local = assembleLoad(body, layout.frames), global = loadOf(body);
  const Vector back = layout.frames.toGlobal(local);
  for (std::size_t i = 0; i < back.size(); ++i)
    EXPECT_NEAR(back[i], global[i], 1e-15);
  EXPECT_GT(std::abs(local[0] - global[0]), 1e-3);
}

} // namespace ndframe
