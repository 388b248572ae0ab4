// Samples of functions that are smooth on tetrahedra and on their faces.

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "ndframe/fem/moment_basis.hpp"
#include "sampling/sample_means.hpp"

namespace ndframe
{

namespace
{

using Corners = std::vector<std::array<double, 3>>;

/// A tetrahedron or a triangle in space of about this size, not flat.
Corners randomSimplex(int dim, double size, std::mt19937& random)
{
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  Corners corners{{uniform(0.0, 1.0), uniform(0.0, 1.0), uniform(0.0, 1.0)}};
  for (std::size_t v = 0; v < std::size_t(dim); ++v) {
    corners.push_back(corners.front());
    for (std::size_t k = 0; k < 3; ++k)
      corners.back()[k] += size * (k == v ? uniform(0.6, 1.0) : uniform(-0.2, 0.2));
  }
  return corners;
}

DataSampler::Vertices pointersTo(const Corners& corners)
{
  DataSampler::Vertices vertices{};
  for (std::size_t v = 0; v < corners.size(); ++v)
    vertices[v] = corners[v].data();
  return vertices;
}

/// A unit cube that is scaled and moved.
struct Frame
{
  double length = 1.0;
  std::array<double, 3> origin{};

  Corners moved(Corners corners) const
  {
    for (auto& corner : corners)
      for (std::size_t k = 0; k < 3; ++k)
        corner[k] = origin[k] + length * corner[k];
    return corners;
  }
  std::string coordinate(std::size_t k) const
  {
    return fmt::format("(({}-({:.17g}))/{:.17g})", "xyz"[k], origin[k], length);
  }
};

/// A sum of a wave, a bell, a front, or a pole outside the cube, with length scales from 0.2 to 3 of it.
std::string randomSmoothFunction(const Frame& frame, std::mt19937& random)
{
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  std::string text = "0";
  for (int term = 0; term < 2; ++term) {
    const double inverse = std::pow(10.0, uniform(-0.5, 0.7));
    const std::string s = fmt::format("({}*{}+{}*{}+{}*{}+{})", inverse * uniform(-1.0, 1.0), frame.coordinate(0),
                                      inverse * uniform(-1.0, 1.0), frame.coordinate(1), inverse * uniform(-1.0, 1.0),
                                      frame.coordinate(2), uniform(-1.0, 1.0));
    const std::string all[] = {"sin" + s, "exp(-" + s + "^2)", "tanh" + s, "1/(1+" + s + "^2)", "sqrt(2+sin" + s + ")"};
    text += fmt::format("+{}*{}", uniform(-1.0, 1.0), all[random() % 5]);
  }
  return text;
}

/// Of a function from its projection on polynomials of degree 5 - dim, root mean square, by a rule.
double distanceFromPolynomials(const ExpressionTree& tree, const DataSampler::Vertices& vertices, int dim,
                               const QuadratureRule& rule)
{
  const MomentBasis basis = MomentBasis::polynomials(dim, 5 - dim);
  std::vector<double> m(std::size_t(basis.size())), moments(m.size(), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    basis.values(rule.point(q), m.data());
    for (std::size_t k = 0; k < m.size(); ++k)
      moments[k] += rule.weights[std::size_t(q)] * valueAt(tree, vertices, dim, 3, rule.point(q)) * m[k];
  }
  double square = 0.0;
  for (int q = 0; q < rule.size(); ++q) {
    basis.values(rule.point(q), m.data());
    double rest = valueAt(tree, vertices, dim, 3, rule.point(q));
    for (std::size_t k = 0; k < m.size(); ++k)
      rest -= moments[k] * m[k];
    square += rule.weights[std::size_t(q)] * rest * rest;
  }
  return std::sqrt(square);
}

} // namespace

/// Looks for a function whose samples are further from it than they say, at the points or in moments: in cubes of any
/// size, far from the origin, on slivers.
TEST(SmoothSolids, OfRandomFunctionsAreNotFurtherFromThemThanTheySay)
{
  std::mt19937 random(3);
  int whole = 0, all = 0;
  for (int scene = 0; scene < 60; ++scene) {
    Frame frame;
    if (scene % 2 == 1) {
      frame.length = std::pow(10.0, std::uniform_real_distribution<>(-3.0, 3.0)(random));
      for (double& coordinate : frame.origin)
        coordinate = std::uniform_real_distribution<>(-30.0, 30.0)(random) * frame.length;
    }
    const std::string text = randomSmoothFunction(frame, random);
    const auto tree = std::make_shared<const ExpressionTree>(text);
    DataSampler sampler({{tree, {}}}, 3);
    const double size = std::pow(10.0, std::uniform_real_distribution<>(-2.0, -0.6)(random));
    for (const int dim : {2, 3}) {
      const QuadratureRule fine = simplexRule(dim, 36);
      for (int cell = 0; cell < 6; ++cell) {
        Corners corners = randomSimplex(dim, size, random);
        if (cell % 3 == 0) // a sliver
          for (auto& corner : corners)
            corner[2] *= 0.01;
        corners = frame.moved(corners);
        const auto vertices = pointersTo(corners);
        const Samples samples = sampler.sample(dim, vertices, 1.0);
        ++all;
        if (samples.pieces.size() > 1 || !samples.areCertain())
          continue;
        ++whole;
        const double allowed = 1.1 * samples.pieces.front().error + 1e-13;
        for (int q = 0; q < samples.rule.size(); ++q)
          ASSERT_NEAR(samples.values[std::size_t(q)], valueAt(*tree, vertices, dim, 3, samples.rule.point(q)), allowed)
              << text;
        double exact = 0.0;
        for (int q = 0; q < fine.size(); ++q)
          exact += fine.weights[std::size_t(q)] * valueAt(*tree, vertices, dim, 3, fine.point(q)) *
                   std::pow(fine.point(q)[dim], 5 - dim);
        ASSERT_NEAR(mean(samples, dim, 5 - dim), exact, 0.5 * samples.uncertainty + 1e-13) << text;
      }
    }
  }
  EXPECT_GE(whole, all * 9 / 10);
}

/// Looks for a function whose distance from polynomials of degree 5 - dim, as the rule gives it, is wrong by more than
/// is charged for it: what norms miss may be a part of the distance, so cells as wide as a wave are looked at, too.
TEST(SmoothSolids, HaveNormsThatMissNoMoreThanTheySay)
{
  std::mt19937 random(8);
  int wide = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const std::string text = randomSmoothFunction({}, random);
    const auto tree = std::make_shared<const ExpressionTree>(text);
    DataSampler sampler({{tree, {}}}, 3);
    const double size = std::pow(10.0, std::uniform_real_distribution<>(-2.0, -0.3)(random));
    for (const int dim : {2, 3})
      for (int cell = 0; cell < 4; ++cell) {
        const Corners corners = randomSimplex(dim, size, random);
        const auto vertices = pointersTo(corners);
        const Samples samples = sampler.sample(dim, vertices, 1.0);
        if (samples.pieces.size() > 1 || !samples.areCertain())
          continue;
        const double exact = distanceFromPolynomials(*tree, vertices, dim, simplexRule(dim, 36));
        ASSERT_NEAR(distanceFromPolynomials(*tree, vertices, dim, samples.rule), exact, 2.0 * samples.spread + 1e-12)
            << text;
        wide += samples.spread > 1e-6 ? 1 : 0; // more than was allowed before
      }
  }
  EXPECT_GE(wide, 10);
}

/// A handful of polynomials serves many small tetrahedra, and rules of 57 points at most.
TEST(SmoothSolids, OfWavesOnAFineMeshComeFromAFewPolynomials)
{
  const auto tree = std::make_shared<const ExpressionTree>("sin(3*x-2*y+z)");
  DataSampler sampler({{tree, {}}}, 3);
  std::mt19937 random(5);
  for (int cell = 0; cell < 1000; ++cell) {
    const Samples samples = sampler.sample(3, pointersTo(randomSimplex(3, 0.02, random)), 1.0);
    ASSERT_TRUE(samples.areCertain());
    ASSERT_EQ(samples.pieces.size(), 1u);
    ASSERT_LE(samples.rule.size(), 57);
  }
  EXPECT_LE(sampler.polynomials(), 8);
}

/// Six tetrahedra a wave: polynomials about the cell tell that a quarter of the points serves, and are right there.
TEST(SmoothSolids, OfShortWavesAreTakenAboutTheCell)
{
  const auto tree = std::make_shared<const ExpressionTree>("sin(10*x-7*y+5*z)");
  DataSampler sampler({{tree, {}}}, 3);
  std::mt19937 random(6);
  for (int cell = 0; cell < 200; ++cell) {
    const Corners corners = randomSimplex(3, 0.05, random);
    const auto vertices = pointersTo(corners);
    const Samples samples = sampler.sample(3, vertices, 1.0);
    ASSERT_TRUE(samples.areCertain());
    ASSERT_EQ(samples.pieces.size(), 1u);
    ASSERT_LE(samples.rule.size(), 214);
    for (int q = 0; q < samples.rule.size(); ++q)
      ASSERT_NEAR(samples.values[std::size_t(q)], valueAt(*tree, vertices, 3, 3, samples.rule.point(q)),
                  samples.pieces.front().error);
  }
}

} // namespace ndframe
