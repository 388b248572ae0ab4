// Samples of functions that are smooth on a plane's cells: values of polynomials on boxes that hold many cells.

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "sampling/sample_means.hpp"

namespace ndframe
{

namespace
{

/// The squares of a grid on [0, 1]^2, two triangles each.
std::vector<std::array<double, 6>> trianglesOfGrid(int cells)
{
  std::vector<std::array<double, 6>> triangles;
  const double h = 1.0 / cells;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double x = i * h, y = j * h;
      triangles.push_back({x, y, x + h, y, x + h, y + h});
      triangles.push_back({x, y, x + h, y + h, x, y + h});
    }
  return triangles;
}

/// At barycentric coordinates of a triangle.
double valueAt(const ExpressionTree& tree, const std::array<double, 6>& triangle, const double* lambda)
{
  return valueAt(tree, {triangle.data(), triangle.data() + 2, triangle.data() + 4, nullptr}, 2, 2, lambda);
}

} // namespace

/// Values of the polynomials that stand for smooth functions: those of the functions, and right in the mean.
TEST(SmoothSamples, OnFineMeshesAreThoseOfTheFunctionsToWithinTheirBound)
{
  const std::vector<std::pair<std::string, double>> functions = {
      {"sin(3*x)*cos(2*y)", (1.0 - std::cos(3.0)) / 3.0 * std::sin(2.0) / 2.0},
      {"exp(2*x - 3*y - 2)", (1.0 - std::exp(-2.0)) / 2.0 * (1.0 - std::exp(-3.0)) / 3.0},
      {"1/(1 + x)^2", 0.5},
      {"x > 0.5 ? exp(y) : 2", 0.5 * (std::exp(1.0) - 1.0) + 1.0},
      {"tanh(200*(x - 0.4))", std::log(std::cosh(120.0) / std::cosh(80.0)) / 200.0}};
  for (const auto& [text, exact] : functions) {
    const auto tree = std::make_shared<const ExpressionTree>(text);
    DataSampler sampler({{tree, {}}}, 2);
    const auto triangles = trianglesOfGrid(40);
    double sum = 0.0;
    for (const auto& x : triangles) {
      const Samples samples = sampler.sample(2, {x.data(), x.data() + 2, x.data() + 4, nullptr}, 1.0);
      ASSERT_TRUE(samples.areCertain()) << text;
      for (int q = 0; q < samples.rule.size(); ++q) {
        const double value = valueAt(*tree, x, samples.rule.point(q));
        EXPECT_NEAR(samples.values[std::size_t(q)], value, 1e-12) << text;
      }
      sum += mean(samples, 0, 0);
    }
    EXPECT_NEAR(sum / double(triangles.size()), exact, 2e-12) << text;
  }
}

/// Waves on 51 200 triangles: the function is evaluated on a handful of boxes, and 19 points are enough in a triangle.
TEST(SmoothSamples, OfWavesOnAFineMeshComeFromPolynomialsOnAFewLargeBoxes)
{
  DataSampler sampler({{std::make_shared<const ExpressionTree>("sin(8*x)*cos(5*y)"), {}}}, 2);
  const auto triangles = trianglesOfGrid(160);
  double sum = 0.0;
  for (const auto& x : triangles) {
    const Samples samples = sampler.sample(2, {x.data(), x.data() + 2, x.data() + 4, nullptr}, 1.0);
    ASSERT_TRUE(samples.areCertain());
    ASSERT_EQ(samples.rule.size(), 19);
    sum += mean(samples, 0, 0);
  }
  EXPECT_LE(sampler.polynomials(), 64);
  EXPECT_NEAR(sum / double(triangles.size()), (1.0 - std::cos(8.0)) / 8.0 * std::sin(5.0) / 5.0, 1e-13);
}

/// Some twelve triangles a wave: none is cut, and moments with polynomials of degree three are right.
TEST(SmoothSamples, OfShortWavesAreOneRuleATriangle)
{
  const auto tree = std::make_shared<const ExpressionTree>("sin(30*x)*cos(25*y)");
  DataSampler sampler({{tree, {}}}, 2);
  const QuadratureRule fine = simplexRule(2, 40);
  for (const auto& x : trianglesOfGrid(65)) {
    const Samples samples = sampler.sample(2, {x.data(), x.data() + 2, x.data() + 4, nullptr}, 1.0);
    ASSERT_TRUE(samples.areCertain());
    ASSERT_EQ(samples.pieces.size(), 1u);
    ASSERT_LE(samples.rule.size(), 169);
    for (const int power : {0, 3}) {
      double exact = 0.0;
      for (int q = 0; q < fine.size(); ++q) {
        const double value = valueAt(*tree, x, fine.point(q));
        exact += fine.weights[std::size_t(q)] * value * std::pow(fine.point(q)[1], power);
      }
      ASSERT_NEAR(mean(samples, 1, power), exact, 2e-12);
    }
  }
}

/// The fewer cells a wave, the more points; all rules that are met are exact for some degree and not for the next.
TEST(SmoothSamples, HaveRulesThatGrowWithTheWavesOfACell)
{
  int last = 1;
  for (const double radians : {1e-3, 0.01, 0.05, 0.1, 0.2, 0.4, 0.6}) {
    DataSampler sampler({{std::make_shared<const ExpressionTree>("sin(x)*cos(y)"), {}}}, 2);
    const double x[] = {0.1, 0.2, 0.1 + radians, 0.2, 0.1, 0.2 + radians};
    const Samples samples = sampler.sample(2, {x, x + 2, x + 4, nullptr}, 1.0);
    ASSERT_EQ(samples.pieces.size(), 1u) << radians;
    EXPECT_GE(samples.rule.size(), last) << radians;
    last = samples.rule.size();
    int exact = 0;
    for (bool isExact = true; isExact; exact += isExact ? 1 : 0)
      for (int i = 0; i <= exact && isExact; ++i) {
        double found = 0.0;
        for (int q = 0; q < samples.rule.size(); ++q)
          found += samples.rule.weights[std::size_t(q)] * std::pow(samples.rule.point(q)[0], i) *
                   std::pow(samples.rule.point(q)[1], exact - i);
        isExact = std::abs(found - meanOfMonomial(2, i, exact - i)) < 1e-15;
      }
    EXPECT_GE(0.5 * exact * (exact + 1), 1.8 * samples.rule.size()) << radians; // 3 is the most that is possible
  }
}

/// A triangle four times as large as those that a box was made for reaches beyond this box.
TEST(SmoothSamples, AreRightInLargeTrianglesAmongSmallOnes)
{
  const std::string text = "sin(6*x)*cos(5*y)";
  const auto tree = std::make_shared<const ExpressionTree>(text);
  DataSampler sampler({{tree, {}}}, 2);
  for (const double h : {0.005, 0.01, 0.02, 0.04})
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 4; ++j) {
        const double a = 0.013 * i, b = 0.1 * j;
        const std::array<double, 6> x{a, b, a + h, b, a, b + h};
        const Samples samples = sampler.sample(2, {x.data(), x.data() + 2, x.data() + 4, nullptr}, 1.0);
        for (int q = 0; q < samples.rule.size(); ++q) {
          const double* lambda = samples.rule.point(q);
          const double point[3] = {a + h * lambda[1], b + h * lambda[2], 0.0};
          double value = 0.0;
          tree->values(point, 1, &value);
          EXPECT_NEAR(samples.values[std::size_t(q)], value, 5.1e-13) << h << ' ' << i << ' ' << j;
        }
      }
}

namespace
{

/// A sum of waves, bells, fronts and poles outside the unit square, with length scales from 0.03 to 3, moved by
/// `offset`.
std::string randomSmoothFunction(std::mt19937& random, double offset)
{
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  const std::string x = fmt::format("(x-({}))", offset), y = fmt::format("(y-({}))", offset);
  std::string text = "0";
  for (int term = 0; term < 2; ++term) {
    const double angle = uniform(0.0, 2.0 * M_PI), inverse = std::pow(10.0, uniform(-0.5, 1.5));
    const std::string s =
        fmt::format("({}*{}+{}*{}+{})", inverse * std::cos(angle), x, inverse * std::sin(angle), y, uniform(-1.0, 1.0));
    const std::string all[] = {"sin" + s,           "exp(-" + s + "^2)",    "tanh" + s,
                               "1/(1+" + s + "^2)", "sqrt(2+sin" + s + ")", "log(3+cos" + s + ")*" + x};
    text += fmt::format("+{}*{}", uniform(-1.0, 1.0), all[random() % 6]);
  }
  return text;
}

} // namespace

/// Looks for a function whose samples are further from it than they say, at the points or in moments.
TEST(SmoothSamples, OfRandomFunctionsAreNotFurtherFromThemThanTheySay)
{
  std::mt19937 random(7);
  const QuadratureRule fine = simplexRule(2, 40);
  int whole = 0, all = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const double offset = scene % 3 == 0 ? 0.0 : std::uniform_real_distribution<>(-20.0, 20.0)(random);
    const std::string text = randomSmoothFunction(random, offset);
    const auto tree = std::make_shared<const ExpressionTree>(text);
    DataSampler sampler({{tree, {}}}, 2);
    const auto triangles = trianglesOfGrid(4 + int(random() % 40));
    for (std::size_t t = 0; t < triangles.size(); t += 7) {
      std::array<double, 6> x = triangles[t];
      for (double& coordinate : x)
        coordinate += offset;
      const Samples samples = sampler.sample(2, {x.data(), x.data() + 2, x.data() + 4, nullptr}, 1.0);
      ++all;
      if (samples.pieces.size() > 1)
        continue;
      ++whole;
      for (int q = 0; q < samples.rule.size(); ++q)
        ASSERT_NEAR(samples.values[std::size_t(q)], valueAt(*tree, x, samples.rule.point(q)), 1.1e-12) << text;
      double exact = 0.0;
      for (int q = 0; q < fine.size(); ++q)
        exact += fine.weights[std::size_t(q)] * valueAt(*tree, x, fine.point(q)) * std::pow(fine.point(q)[2], 3);
      ASSERT_NEAR(mean(samples, 2, 3), exact, 2e-12) << text;
    }
  }
  EXPECT_GE(whole, all * 3 / 5);
}

} // namespace ndframe
