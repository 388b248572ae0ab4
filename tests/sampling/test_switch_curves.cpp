// Data that switch along a curve, by their samples against closed forms and against integrals line by line.

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

namespace
{

using Point = std::array<double, 3>;

std::string number(double value)
{
  return fmt::format("({:.17g})", value);
}

struct Triangle
{
  std::array<Point, 3> x;

  double area() const
  {
    return 0.5 * std::abs((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]));
  }
  double at(const double* lambda, std::size_t axis) const
  {
    return lambda[0] * x[0][axis] + lambda[1] * x[1][axis] + lambda[2] * x[2][axis];
  }
};

Samples sample(const std::vector<std::string>& texts, const Triangle& triangle, int space = 2)
{
  std::vector<SampledFunction> functions;
  const auto refuse = [](const double*, int, double) { throw std::domain_error("not finite"); };
  for (const auto& text : texts)
    functions.push_back({std::make_shared<const ExpressionTree>(text), refuse});
  DataSampler sampler(std::move(functions), space, DataSampler::Cuts::Curved);
  return sampler.sample(2, {triangle.x[0].data(), triangle.x[1].data(), triangle.x[2].data(), nullptr}, 1.0);
}

/// int f x^i y^j over the triangle by the samples of the first function.
double integral(const Samples& samples, const Triangle& triangle, int i, int j)
{
  const std::size_t functions = samples.values.size() / samples.rule.weights.size();
  double sum = 0.0;
  for (int q = 0; q < samples.rule.size(); ++q)
    sum += samples.rule.weights[std::size_t(q)] * samples.values[std::size_t(q) * functions] *
           std::pow(triangle.at(samples.rule.point(q), 0), i) * std::pow(triangle.at(samples.rule.point(q), 1), j);
  return sum * triangle.area();
}

/// The square [0, 1]^2 as triangles with inner vertices moved at random.
std::vector<Triangle> square(int cells, test::Random& random)
{
  std::vector<Point> vertices;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const bool isInner = i > 0 && j > 0 && i < cells && j < cells;
      const double shift = isInner ? 0.25 : 0.0;
      vertices.push_back({(i + random(-shift, shift)) / cells, (j + random(-shift, shift)) / cells, 0.0});
    }
  const auto vertex = [&](int i, int j) { return vertices[std::size_t(j * (cells + 1) + i)]; };
  std::vector<Triangle> all;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      all.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)}});
      all.push_back({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)}});
    }
  return all;
}

struct Total
{
  double value = 0.0;
  bool isCertain = true;
  int points = 0;
};

Total total(const std::string& text, const std::vector<Triangle>& triangles, int i, int j)
{
  Total all;
  for (const auto& triangle : triangles) {
    const Samples samples = sample({text}, triangle);
    all.value += integral(samples, triangle, i, j);
    all.isCertain = all.isCertain && samples.areCertain();
    all.points += samples.rule.size();
  }
  return all;
}

/// int (0, 1) x^n over y > p(x) inside a triangle, line by line: Gauss rules between the places where p crosses it.
class AboveCurve
{
public:
  AboveCurve(const Triangle& triangle, std::function<double(double)> p) : triangle_(triangle), p_(std::move(p)) {}

  double integral(int n) const
  {
    std::vector<double> ends;
    for (const auto& vertex : triangle_.x)
      ends.push_back(vertex[0]);
    std::sort(ends.begin(), ends.end());
    double sum = 0.0;
    for (std::size_t part = 0; part + 1 < ends.size(); ++part)
      sum += between(ends[part], ends[part + 1], n);
    return sum;
  }

private:
  /// The lowest and highest y of the triangle at x.
  std::array<double, 2> range(double x) const
  {
    std::array<double, 2> y{1e300, -1e300};
    for (std::size_t a = 0; a < 3; ++a) {
      const Point &from = triangle_.x[a], &to = triangle_.x[(a + 1) % 3];
      if ((from[0] - x) * (to[0] - x) > 0.0 || from[0] == to[0])
        continue;
      const double here = from[1] + (to[1] - from[1]) * (x - from[0]) / (to[0] - from[0]);
      y = {std::min(y[0], here), std::max(y[1], here)};
    }
    return y;
  }
  double height(double x) const
  {
    const auto y = range(x);
    return std::max(0.0, y[1] - std::max(y[0], p_(x)));
  }
  int kind(double x) const
  {
    const auto y = range(x);
    return int(p_(x) > y[0]) + int(p_(x) > y[1]);
  }
  double between(double a, double b, int n) const
  {
    constexpr int parts = 2000;
    double sum = 0.0;
    for (int part = 0; part < parts; ++part)
      sum += smooth(a + (b - a) * part / parts, a + (b - a) * (part + 1) / parts, n, 60);
    return sum;
  }
  double smooth(double a, double b, int n, int depth) const
  {
    const double margin = 1e-9 * (b - a);
    if (depth > 0 && kind(a + margin) != kind(b - margin))
      return smooth(a, 0.5 * (a + b), n, depth - 1) + smooth(0.5 * (a + b), b, n, depth - 1);
    static const QuadratureRule gauss = simplexRule(1, 7);
    double sum = 0.0;
    for (int q = 0; q < gauss.size(); ++q) {
      const double x = a + (b - a) * gauss.point(q)[1];
      sum += gauss.weights[std::size_t(q)] * std::pow(x, n) * height(x);
    }
    return sum * (b - a);
  }

  const Triangle& triangle_;
  std::function<double(double)> p_;
};

} // namespace

TEST(SwitchCurves, OfDisksHaveTheDisksMoments)
{
  test::Random random(11);
  for (int scene = 0; scene < 40; ++scene) {
    const double r = std::pow(10.0, random(-2.0, -0.4)), a = random(r, 1.0 - r), b = random(r, 1.0 - r);
    const std::string text = "(x - " + number(a) + ")^2 + (y - " + number(b) + ")^2 < " + number(r) + "^2";
    const auto triangles = square(int(random(1.0, 7.0)), random);
    const double area = M_PI * r * r;
    const Total mean = total(text, triangles, 0, 0);
    EXPECT_TRUE(mean.isCertain) << text;
    EXPECT_NEAR(mean.value, area, 1e-11) << text;
    EXPECT_NEAR(total(text, triangles, 1, 0).value, a * area, 1e-11) << text;
    EXPECT_NEAR(total(text, triangles, 1, 1).value, a * b * area, 1e-11) << text;
    EXPECT_NEAR(total(text, triangles, 0, 2).value, (b * b + 0.25 * r * r) * area, 1e-11) << text;
  }
}

TEST(SwitchCurves, OfRingsSegmentsUnionsAndKinksHaveTheirMoments)
{
  test::Random random(12);
  const std::string r = "((x - 0.47)^2 + (y - 0.51)^2)";
  const double ofR = (std::pow(0.53, 3) + std::pow(0.47, 3) + std::pow(0.49, 3) + std::pow(0.51, 3)) / 3.0;
  const std::vector<std::pair<std::string, double>> known{
      {"(" + r + " < 0.16)*(" + r + " > 0.09)", M_PI * 0.07},
      {"(" + r + " < 0.16 && x > 0.47) ? 3 : 0", 3.0 * 0.5 * M_PI * 0.16},
      {"max(0, 0.16 - " + r + ")", 0.5 * M_PI * 0.16 * 0.16},
      {"abs(" + r + " - 0.16) + " + r, M_PI * 0.16 * 0.16 - 0.16 + 2.0 * ofR},
      {"((x - 0.3)^2 + (y - 0.3)^2 < 0.01 || (x - 0.7)^2 + (y - 0.6)^2 < 0.02) ? 1 : 0", M_PI * 0.03},
      {"((x - 0.5)^2/4 + (y - 0.5)^2 < 0.04)*exp(0*x)", 2.0 * M_PI * 0.04},
      {"sqrt((x - 0.5)^2 + (y - 0.5)^2) < 0.3", M_PI * 0.09},
      {"y < 0.2 + 0.3*x^2", 0.3},
      {"x*y > 0.1", 0.9 - 0.1 * std::log(10.0)}};
  for (const auto& [text, value] : known)
    for (int cells = 1; cells < 7; ++cells) {
      const Total mean = total(text, square(cells, random), 0, 0);
      EXPECT_TRUE(mean.isCertain) << text;
      EXPECT_NEAR(mean.value, value, 2e-11) << text << " on " << cells;
    }
}

TEST(SwitchCurves, OfRandomCubicsHaveIntegralsLineByLine)
{
  test::Random random(13);
  int certain = 0;
  for (int scene = 0; scene < 60; ++scene) {
    Triangle triangle;
    do
      for (auto& vertex : triangle.x)
        vertex = {random(-1.0, 1.0), random(-1.0, 1.0), 0.0};
    while (triangle.area() < 1e-3);
    double c[4];
    for (double& coefficient : c)
      coefficient = random(-1.0, 1.0);
    const std::string text =
        "y > " + number(c[0]) + " + x*(" + number(c[1]) + " + x*(" + number(c[2]) + " + x*" + number(c[3]) + "))";
    const AboveCurve lines(triangle, [&](double x) { return c[0] + x * (c[1] + x * (c[2] + x * c[3])); });
    const Samples samples = sample({text}, triangle);
    certain += samples.areCertain();
    for (int n = 0; n < 3; ++n)
      EXPECT_NEAR(integral(samples, triangle, n, 0), lines.integral(n), (1e-10 + samples.uncertainty) * triangle.area())
          << text << " " << n;
    EXPECT_LT(samples.rule.size(), 5000) << text;
  }
  EXPECT_EQ(certain, 60);
}

/// Pieces of one simplex have either all their own rules, or there are several.
TEST(SwitchCurves, OutsideATriangleLeaveItsRule)
{
  const Triangle triangle{{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}}};
  for (const double reach : {0.99, 0.9999, 1.0}) {
    const Samples samples =
        sample({"(x + 1.3)^2 + (y + 0.2)^2 - x*y/50 < " + number(1.69 + 0.04) + "*" + number(reach)}, triangle);
    EXPECT_TRUE(samples.areCertain());
    for (const auto& piece : samples.pieces)
      EXPECT_TRUE(piece.rule != nullptr || samples.pieces.size() > 1);
    double sum = 0.0;
    for (const double weight : samples.rule.weights)
      sum += weight;
    EXPECT_NEAR(sum, 1.0, 1e-13);
  }
}

TEST(SwitchCurves, AreSeenByAllFunctionsThatSwitchThere)
{
  const Triangle triangle{{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}}};
  const Samples samples = sample({"x^2 + y^2 < 0.25", "1 + x*(x^2 + y^2 >= 0.25)"}, triangle);
  EXPECT_TRUE(samples.areCertain());
  EXPECT_NEAR(integral(samples, triangle, 0, 0), M_PI / 16.0, 1e-12);
  double second = 0.0;
  for (std::size_t q = 0; q < samples.rule.weights.size(); ++q)
    second += 0.5 * samples.rule.weights[q] * samples.values[2 * q + 1];
  EXPECT_NEAR(second, 0.5 + 1.0 / 6.0 - 0.125 / 3.0, 1e-12); // int x over the quarter disk r^3 / 3
}

/// Whatever the curve: the halves of a triangle make up the triangle, and the two signs what is between them.
TEST(SwitchCurves, AgreeWithThoseOfTheHalvesOfATriangle)
{
  test::Random random(15);
  int certain = 0;
  constexpr int scenes = 150;
  for (int scene = 0; scene < scenes; ++scene) {
    const auto r = [&](double range) { return number(random(-range, range)); };
    const std::vector<std::string> kinds{"sin(" + r(6) + "*x + " + r(1) + ")*cos(" + r(6) + "*y) + " + r(0.5),
                                         "exp(" + r(2) + "*x) + " + r(2) + "*y^2 - 1 + " + r(0.3) + "*x*y",
                                         "x*y + " + r(0.2),
                                         "x^3 - 3*x*y^2 + " + r(0.1),
                                         "(x^2 + y^2)^2 - (x^2 - y^2)*" + r(1) + "^2 + " + r(0.05),
                                         "sqrt(1.5 + x)*y + tanh(" + r(9) + "*x)",
                                         "(x + " + r(0.5) + ")^2 + (y + " + r(0.5) + ")^2/" +
                                             number(random(1e-4, 1.0)) + " - " + number(random(0.0, 0.3))};
    const std::string s = kinds[std::size_t(scene) % kinds.size()];
    Triangle whole;
    do
      for (auto& vertex : whole.x)
        vertex = {random(-1.0, 1.0), random(-1.0, 1.0), 0.0};
    while (whole.area() < 1e-2);
    Triangle first = whole, second = whole;
    for (std::size_t k = 0; k < 2; ++k)
      first.x[0][k] = second.x[1][k] = 0.5 * (whole.x[0][k] + whole.x[1][k]);
    const std::string text = "(" + s + " > 0) ? 2 - x : 1 + x*y";
    const Samples all = sample({text}, whole), a = sample({text}, first), b = sample({text}, second);
    certain += all.areCertain() && a.areCertain() && b.areCertain();
    const double allowed = (all.uncertainty + a.uncertainty + b.uncertainty + 1e-12) * 3.0 * whole.area();
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(integral(all, whole, i, 1), integral(a, first, i, 1) + integral(b, second, i, 1), allowed) << text;
  }
  EXPECT_GE(certain, scenes - 3); // curves may end or cross in a triangle
}

/// A facet in space: a sphere cuts a disk out of its plane.
TEST(SwitchCurves, AreFoundOnTrianglesInSpace)
{
  test::Random random(14);
  for (int scene = 0; scene < 10; ++scene) {
    const double turn = random(0.0, 6.0), tilt = random(0.2, 1.4), r = random(0.1, 0.25);
    const Point u{std::cos(turn), std::sin(turn), 0.0};
    const Point v{-std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt)};
    const auto place = [&](double a, double b) {
      return Point{a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
    };
    const Triangle triangle{{{place(0.0, 0.0), place(2.0, 0.1), place(0.2, 1.7)}}};
    const Point c = place(0.6, 0.6);
    const std::string text = "(x - " + number(c[0]) + ")^2 + (y - " + number(c[1]) + ")^2 + (z - " + number(c[2]) +
                             ")^2 < " + number(r) + "^2";
    const Samples samples = sample({text}, triangle, 3);
    EXPECT_TRUE(samples.areCertain());
    double share = 0.0;
    for (std::size_t q = 0; q < samples.rule.weights.size(); ++q)
      share += samples.rule.weights[q] * samples.values[q];
    EXPECT_NEAR(share, M_PI * r * r / (0.5 * (2.0 * 1.7 - 0.1 * 0.2)), 1e-11);
  }
}

/// A root of the curve's function has no bounded slope on either side: nothing is located.
TEST(SwitchCurves, OfRootsStayUncertain)
{
  const Triangle triangle{{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}}};
  const Samples samples = sample({"sqrt(max(0, 0.25 - x^2 - y^2))"}, triangle);
  EXPECT_NEAR(integral(samples, triangle, 0, 0), M_PI / 6.0 * 0.125, samples.uncertainty * 0.5);
}

} // namespace ndframe
