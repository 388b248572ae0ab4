#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"
#include "ndframe/admissibility/prescribed_charge.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

test::Condition displacement(const std::string& side, std::vector<std::pair<std::string, std::string>> entries)
{
  test::Condition condition = test::onSide("Displacement", side);
  condition.entries.insert(condition.entries.end(), entries.begin(), entries.end());
  return condition;
}

PrescribedCharge charge(const Mesh& mesh, int order, std::vector<test::Condition> supports)
{
  return chargePrescribed(test::makeBody(mesh, order, {std::move(supports), {}}));
}

/// One triangle whose edge from (0.2, 0) to (1.1, 0) is the side "bottom" and whose edge on the left is "left".
Mesh triangle()
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0.2, 0.0, 1.1, 0.0, 0.4, 0.8};
  mesh.cells = {0, 1, 2};
  mesh.sides = {{"bottom", {{0, 2}}}, {"left", {{0, 1}}}};
  return mesh;
}

/// The lifting of a function on the triangle's bottom: s delta(y), s = 1 on the bottom and 0 at the top.
double lifted(const std::function<double(double)>& delta, double x, double y)
{
  const double s = 1.0 - y / 0.8; // the point of the bottom on the line from the top
  return s * delta(0.4 + (x - 0.4) / s);
}

} // namespace

struct Charges : testing::TestWithParam<int>
{
  int order = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Orders, Charges, testing::Values(1, 2), testing::PrintToStringParamName());

TEST_P(Charges, AreZeroForDataThatTheElementsMeet)
{
  const std::string value = order == 1 ? "0.1 - 2*x + y" : "0.1*x^2 - x*y";
  for (const Mesh& mesh : {test::box({3, 2}, "Right", 20.0), test::box({2, 1, 1})}) {
    const auto result = charge(mesh, order,
                               {displacement("left", {{"X", value}}), displacement("top", {{"X", value}, {"Y", "0.3"}}),
                                test::onSide("Roller", "bottom"), test::onSide("Clamp", "right")});
    EXPECT_EQ(result.charge, 0.0);
    EXPECT_EQ(result.caveat, "");
  }
}

TEST_P(Charges, AreTheEnergyOfTheLifting)
{
  const BodyModel body =
      test::makeBody(triangle(), order, {{displacement("bottom", {{"X", "sin(3*x)"}, {"Y", "exp(x)"}})}, {}});
  const auto delta = [this](double (*f)(double)) {
    return [this, f](double x) {
      const double a = 0.2, b = 1.1, t = (x - a) / (b - a), middle = f(0.5 * (a + b));
      const double linear = (1.0 - t) * f(a) + t * f(b);
      return f(x) - linear - (order == 1 ? 0.0 : 4.0 * t * (1.0 - t) * (middle - 0.5 * (f(a) + f(b))));
    };
  };
  const std::array<std::function<double(double)>, 2> data{delta([](double x) { return std::sin(3.0 * x); }),
                                                          delta([](double x) { return std::exp(x); })};
  const QuadratureRule rule = simplexRule(2, 40);
  const double h = 1e-5;
  double energy = 0.0;
  for (int q = 0; q < rule.size(); ++q) {
    const double* lambda = rule.point(q);
    // The rule collapses the square in its vertex 1; the gradient depends on the direction from the top alone.
    const double x = 0.2 * lambda[0] + 1.1 * lambda[2] + 0.4 * lambda[1], y = 0.8 * lambda[1];
    double g[2][2];
    for (std::size_t k = 0; k < 2; ++k) {
      g[k][0] = (lifted(data[k], x + h, y) - lifted(data[k], x - h, y)) / (2.0 * h);
      g[k][1] = (lifted(data[k], x, y + h) - lifted(data[k], x, y - h)) / (2.0 * h);
    }
    const double strain[3] = {g[0][0], g[1][1], g[0][1] + g[1][0]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        energy += cellMeasure(body.mesh, 0) * rule.weights[std::size_t(q)] * strain[i] * body.laws(0)(i, j) * strain[j];
  }
  EXPECT_NEAR(chargePrescribed(body).charge, std::sqrt(energy), 1e-7 * std::sqrt(energy));
}

TEST_P(Charges, OfTwoFacetsOfACellAddUp)
{
  const auto bottom = displacement("bottom", {{"X", "sin(3*x)"}}), left = displacement("left", {{"Y", "cos(2*y)"}});
  EXPECT_NEAR(charge(triangle(), order, {bottom, left}).charge,
              charge(triangle(), order, {bottom}).charge + charge(triangle(), order, {left}).charge, 1e-14);
}

TEST_P(Charges, FallFasterThanTheErrorOfTheElements)
{
  const auto at = [this](int n) {
    return charge(test::box({n, n}), order, {displacement("bottom", {{"X", "sin(3*x)"}})}).charge;
  };
  const double ratio = at(8) / at(16);
  EXPECT_NEAR(std::log2(ratio), order + 0.5, 0.1);
}

TEST_P(Charges, SeveralSupportsOfAFacetActTogether)
{
  // u . n = 0 and u_x = g on a line inclined by 30 degrees: u = g (1, tan 30).
  const Mesh mesh = test::box({3, 2}, "Right", 30.0);
  const auto combined =
      charge(mesh, order, {test::onSide("Roller", "bottom"), displacement("bottom", {{"X", "sin(3*x)"}})});
  const auto given = charge(mesh, order, {displacement("bottom", {{"X", "sin(3*x)"}, {"Y", "sin(3*x)/sqrt(3)"}})});
  EXPECT_GT(given.charge, 1e-3);
  EXPECT_NEAR(combined.charge, given.charge, 1e-7 * given.charge); // what polynomials may miss is bounded differently
}

TEST_P(Charges, OfAKinkAreFiniteAndCertain)
{
  const auto kink = charge(test::box({3, 2}), order, {displacement("bottom", {{"Y", "abs(x - 0.4)"}})});
  EXPECT_GT(kink.charge, 1e-2);
  EXPECT_LT(kink.charge, 2.0);
  EXPECT_EQ(kink.caveat, "");
}

TEST_P(Charges, AreNotKnownInSpace)
{
  const auto result = charge(test::box({2, 1, 1}), order, {displacement("left", {{"X", "sin(3*y)"}})});
  EXPECT_EQ(result.charge, 0.0);
  EXPECT_THAT(result.caveat, testing::HasSubstr("prescribed on body are met at nodes only"));
}

} // namespace ndframe
