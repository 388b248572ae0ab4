// The tree of an expression against muParser, its grammar's reference, on random expressions; and enclosures against
// values at random points of the region.

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <muParser.h>

#include "ndframe/base/expression.hpp"
#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

namespace
{

/// Random expressions, with a given number of levels.
class Generator
{
public:
  explicit Generator(unsigned seed) : engine_(seed) {}

  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int whole(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

  std::string text(int levels)
  {
    if (levels == 0)
      return pick({"x", "y", "z", "x", "pi", std::to_string(real(0.0, 3.0)), "2"});
    const auto a = [&] { return text(levels - 1 - whole(levels)); };
    switch (whole(9)) {
    case 0:
      return "-(" + a() + ")";
    case 1:
      return "(" + a() + ")" + pick({"^2", "^3", "^0.5", "^-1", "^2^0.5"});
    case 2:
      return pick(unary) + "(" + a() + ")";
    case 3:
      return pick({"min", "max", "sum", "avg"}) + "(" + a() + ", " + a() + ", " + a() + ")";
    case 4:
      return "((" + a() + pick({"<", ">", "<=", ">=", "==", "!="}) + a() + pick({" && ", " || "}) + a() + "> 0.1) ? " +
             a() + " : " + a() + ")";
    case 5:
      return a() + " - (" + a() + ")";
    case 6:
      return a() + "+" + a();
    case 7:
      return a() + "*" + a();
    default:
      return a() + "/" + "(" + a() + ")";
    }
  }

private:
  std::string pick(const std::vector<std::string>& from) { return from[std::size_t(whole(int(from.size())))]; }

  const std::vector<std::string> unary{"sin",  "cos",   "tan",   "asin",  "acos", "atan", "sinh",
                                       "cosh", "tanh",  "asinh", "acosh", "log",  "log2", "log10",
                                       "ln",   "atanh", "exp",   "sqrt",  "abs",  "sign", "rint"};
  std::mt19937 engine_;
};

/// muParser's value; NaN where it refuses constants that are not defined.
double reference(const std::string& text, std::array<double, 3> x)
try {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", M_PI);
  const char* names[] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    parser.DefineVar(names[k], &x[k]);
  parser.SetExpr(text);
  return parser.Eval();
} catch (const mu::ParserError&) {
  return std::nan("");
}

double valueOfText(const ExpressionTree& tree, const std::array<double, 3>& x)
{
  double value = 0.0;
  tree.values(x.data(), 1, &value);
  return value;
}

Enclosure enclosureOn(const std::string& text, double from, double to)
{
  return enclose(ExpressionTree(text), Region::simplex({{from, 0.0, 0.0}, {to, 0.0, 0.0}}));
}

} // namespace

TEST(ExpressionTree, HasTheValuesOfMuParser)
{
  Generator random(1);
  int finite = 0;
  for (int sample = 0; sample < 4000; ++sample) {
    const std::string text = random.text(4);
    const ExpressionTree tree(text);
    const std::array<double, 3> x{random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)};
    const double expected = reference(text, x), value = valueOfText(tree, x);
    if (!std::isfinite(expected)) {
      EXPECT_FALSE(std::isfinite(value) && std::abs(value) < 1e8) << text;
      continue;
    }
    ++finite;
    EXPECT_NEAR(value, expected, 1e-9 * (1.0 + std::abs(expected)))
        << text << " at " << x[0] << " " << x[1] << " " << x[2];
  }
  EXPECT_GT(finite, 2000);
}

TEST(ExpressionTree, FollowsThePrioritiesOfMuParser)
{
  for (const char* text : {"-x^2", "2^3^2", "2^-x", "-2^-x^2", "x-y-z", "x/y/z", "x<y<z", "1+x>y && z<2 || x==y",
                           "x<y ? 1 : y<z ? 2 : 3", "-x*-y", "+x", "x*y^2/z", "1e-3*x+.5*y+2.", "x^2*y", "(x<y)*z"})
    for (const auto& x : {std::array<double, 3>{1.5, 0.5, 2.0}, std::array<double, 3>{-0.5, 0.25, 3.0}})
      EXPECT_DOUBLE_EQ(valueOfText(ExpressionTree(text), x), reference(text, x)) << text;
}

TEST(ExpressionTree, EvaluatesManyPointsAtOnce)
{
  const ExpressionTree tree("sin(x)*y + (z > 0.5)");
  std::vector<double> points, values(1000);
  for (int i = 0; i < 3000; ++i)
    points.push_back(0.001 * i);
  tree.values(points.data(), 1000, values.data());
  for (std::size_t i = 0; i < 1000; ++i)
    EXPECT_EQ(values[i], valueOfText(tree, {points[3 * i], points[3 * i + 1], points[3 * i + 2]}));
}

TEST(ExpressionTree, KnowsPolynomialsAndAffineFunctions)
{
  const auto degree = [](const char* text) { return ExpressionTree(text).root().degree; };
  EXPECT_EQ(degree("3"), 0);
  EXPECT_EQ(degree("2*x - y/4 + 1"), 1);
  EXPECT_EQ(degree("x*y + (x - 1)^3"), 3);
  EXPECT_EQ(degree("(x + y)^2*(z - 1)^2/3"), 4);
  EXPECT_EQ(degree("x^0.5"), -1);
  EXPECT_EQ(degree("1/x"), -1);
  EXPECT_EQ(degree("abs(x)"), -1);
  EXPECT_EQ(ExpressionTree("2*(x - 3*y)/4 + z - 1").root().affine, (AffineFunction{-1.0, 0.5, -1.5, 1.0}));
  EXPECT_TRUE(ExpressionTree("2*pi").isConstant());
  EXPECT_FALSE(ExpressionTree("0*x").isConstant());
}

TEST(ExpressionTree, RefusesWhatIsNestedTooDeeply)
{
  const std::string deep = std::string(5000, '(') + "x" + std::string(5000, ')');
  EXPECT_THROW(const ExpressionTree tree(deep), std::invalid_argument);
}

TEST(Enclosure, ContainsTheValuesOfRandomExpressions)
{
  Generator random(2);
  int bounded = 0;
  for (int sample = 0; sample < 3000; ++sample) {
    const std::string text = random.text(3);
    const ExpressionTree tree(text);
    std::vector<Region::Point> corners;
    for (int v = 0; v < 4; ++v)
      corners.push_back({random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)});
    const double size = std::pow(10.0, random.real(-3, 0));
    for (std::size_t v = 1; v < 4; ++v)
      for (std::size_t k = 0; k < 3; ++k)
        corners[v][k] = corners[0][k] + size * (corners[v][k] - corners[0][k]);
    const Enclosure enclosure = enclose(tree, Region::simplex(corners));
    bounded += enclosure.range.isBounded();
    for (int point = 0; point < 20; ++point) {
      std::array<double, 4> weight{};
      double total = 0.0;
      for (double& w : weight)
        total += w = -std::log(random.real(1e-9, 1.0));
      std::array<double, 3> x{};
      for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t k = 0; k < 3; ++k)
          x[k] += weight[v] / total * corners[v][k];
      const double value = valueOfText(tree, x);
      if (std::isfinite(value)) {
        const double slack = 1e-12 * (1.0 + std::abs(value));
        EXPECT_LE(enclosure.range.lo, value + slack) << text;
        EXPECT_GE(enclosure.range.hi, value - slack) << text;
      }
    }
  }
  EXPECT_GT(bounded, 1500);
}

TEST(Enclosure, BoundsWhatTaylorPolynomialsMiss)
{
  // the Taylor polynomial about the middle by differences in high precision: f(x) minus its degree-2 polynomial
  for (const char* text : {"exp(x)", "sin(3*x)", "1/(2 + x)", "sqrt(1.5 + x)", "tanh(2*x)", "atan(2*x)", "log(2 + x)",
                           "(1.5 + x)^1.7", "cosh(x)*x", "asin(x/2)", "asinh(3*x)", "tan(x/2)", "(2 + x)^-3",
                           "acosh(3 + x)", "atanh(x/3)", "2^x", "x^5 - 2*x^3"})
  {
    const ExpressionTree tree(text);
    const auto f = [&](long double x) { return (long double)valueOfText(tree, {double(x), 0.0, 0.0}); };
    for (const double half : {0.5, 0.1}) {
      const Enclosure enclosure = enclosureOn(text, 0.2 - half, 0.2 + half);
      const long double step = 1e-3L;
      const long double slope = (f(0.2L + step) - f(0.2L - step)) / (2 * step);
      const long double bend = (f(0.2L + step) - 2 * f(0.2L) + f(0.2L - step)) / (step * step);
      double missed = 0.0;
      for (double s = -half; s <= half; s += half / 64)
        missed = std::max(missed, double(std::abs(f(0.2L + s) - f(0.2L) - slope * s - 0.5L * bend * s * s)));
      EXPECT_GE(enclosure.remainder[3] * (1 + 1e-3) + 1e-5 * half, missed) << text << " " << half;
      EXPECT_LE(enclosure.distance(9), enclosure.distance(2)) << text;
    }
    EXPECT_LT(enclosureOn(text, 0.19, 0.21).distance(9), 1e-13) << text;
  }
}

TEST(Enclosure, OfHighOrderBeginsWithThatOfALowerOneAndBoundsMore)
{
  const double half = 0.4;
  const Region region = Region::simplex({{-half, 0.0, 0.0}, {half, 0.0, 0.0}});
  for (const char* text : {"sin(x)", "exp(x)*cos(2*x)", "1/(2 + x)", "tanh(x)", "sqrt(2 + x^2)", "x^13"}) {
    const ExpressionTree tree(text);
    const Enclosure low = enclose(tree, region), high = enclose(tree, region, -1, Enclosure::longest);
    for (std::size_t n = 0; n <= Enclosure::longest; ++n) {
      EXPECT_EQ(std::isfinite(low.remainder[n]), n <= Enclosure::order) << text << ' ' << n;
      if (n <= Enclosure::order) {
        EXPECT_EQ(low.remainder[n], high.remainder[n]) << text << ' ' << n;
      }
    }
  }
  const Enclosure wave = enclose(ExpressionTree("sin(x)"), region, -1, Enclosure::longest);
  for (std::size_t n = 2; n <= Enclosure::longest; n += 2) // sup |cos| is 1 for odd n, sup |sin| is sin(0.4) for even n
    EXPECT_NEAR(wave.remainder[n] / (std::sin(half) * std::pow(half, double(n)) / std::tgamma(double(n) + 1.0)), 1.0,
                1e-12)
        << n;
  EXPECT_EQ(enclose(ExpressionTree("x^13"), region, -1, Enclosure::longest).remainder[14], 0.0);
}

TEST(Enclosure, KnowsKinksAndJumps)
{
  const Enclosure kink = enclosureOn("abs(2*x - 0.6)", 0.0, 1.0), jump = enclosureOn("(x > 0.3)*x", 0.0, 1.0);
  EXPECT_NEAR(kink.remainder[1], 1.0, 1e-12); // Lipschitz constant 2, from the middle 0.5
  EXPECT_TRUE(std::isinf(kink.remainder[2]));
  ASSERT_TRUE(kink.cut.has_value());
  EXPECT_NEAR((*kink.cut)[0] / (*kink.cut)[1], -0.3, 1e-15);
  EXPECT_TRUE(std::isinf(jump.remainder[1]));
  EXPECT_GE(jump.range.hi, 1.0);
  ASSERT_TRUE(jump.cut.has_value());
  EXPECT_EQ(enclosureOn("(x > 0.3)*x", 0.3, 1.0).distance(1), 0.0);
  EXPECT_LT(enclosureOn("sqrt(x - 0.3)", 0.4, 0.42).distance(9), 1e-9);
  EXPECT_TRUE(std::isinf(enclosureOn("1/x", -1.0, 1.0).distance(9)));
  EXPECT_FALSE(enclosureOn("rint(4*x)", 0.13, 0.37).cut.has_value());
  EXPECT_TRUE(enclosureOn("rint(4*x)", 0.0, 1.0).cut.has_value());
}

TEST(Enclosure, SeesWhatLiesBetweenPoints)
{
  const Enclosure needle = enclosureOn("1 + 100*exp(-((x - 0.3217)/1e-6)^2)", 0.0, 1.0);
  EXPECT_GE(needle.range.hi, 101.0);
  EXPECT_GE(needle.distance(9), 49.0);
  EXPECT_LT(enclosureOn("1 + 100*exp(-((x - 0.3217)/1e-6)^2)", 0.33, 1.0).distance(0), 1e-15);
}

TEST(Enclosure, AlongACurveBoundsTheValuesOfRandomExpressions)
{
  Generator random(3);
  int bounded = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    const std::string text = random.text(3);
    const ExpressionTree tree(text);
    Curve curve;
    for (auto& polynomial : curve)
      for (int k = 0; k < 6; ++k)
        polynomial.push_back(random.real(-1.0, 1.0) * (k == 0 ? 2.0 : std::pow(0.3, k)));
    const double bound = largestAlong(tree, curve);
    bounded += std::isfinite(bound);
    for (int point = 0; point <= 40; ++point) {
      const double t = -1.0 + 0.05 * point;
      std::array<double, 3> x{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 6; k-- > 0;)
          x[axis] = x[axis] * t + curve[axis][k];
      const double value = std::abs(valueOfText(tree, x));
      if (std::isfinite(value)) {
        EXPECT_GE(bound, value * (1.0 - 1e-12)) << text << " at " << t;
      }
    }
  }
  EXPECT_GT(bounded, 500);
  // close where the expression is smooth
  EXPECT_LT(largestAlong(ExpressionTree("sin(x)"), {{{0.5, 0.1}, {}, {}}}), std::sin(0.6) + 1e-3);
  EXPECT_LT(largestAlong(ExpressionTree("x^2 + y^2 - 1"), {{{0.0, 0.2}, {1.0, 0.0, -0.02, 0.0, -0.0002}, {}}}), 1e-5);
}

TEST(Enclosure, WithADecidedSwitchIsThatOfOneSide)
{
  const ExpressionTree tree("x^2 + y^2 < 1 ? x : 5 + y");
  const Region region = Region::simplex({{0.5, 0.5, 0.0}, {0.9, 0.6, 0.0}, {0.6, 0.9, 0.0}});
  const Enclosure open = enclose(tree, region);
  ASSERT_GE(open.curved, 0);
  EXPECT_TRUE(tree.part(open.curved).isSame(ExpressionTree("x^2 + y^2 - 1")));
  EXPECT_FALSE(tree.part(open.curved).isSame(ExpressionTree("x^2 + y^2 - 2")));
  EXPECT_GT(open.distance(9), 1.0);
  const Enclosure inside = enclose(tree, region, -1, 1, {open.curved, -1.0});
  const Enclosure outside = enclose(tree, region, -1, 1, {open.curved, 1.0});
  EXPECT_NEAR(inside.range.lo, 0.5, 1e-14);
  EXPECT_NEAR(inside.range.hi, 0.9, 1e-14);
  EXPECT_NEAR(outside.range.lo, 5.5, 1e-14);
  EXPECT_NEAR(outside.range.hi, 5.9, 1e-14);
  EXPECT_EQ(enclosureOn("x < 0.5", 0.0, 1.0).curved, -1);
  EXPECT_GE(enclosureOn("abs(x^2 - 0.5)", 0.0, 1.0).curved, 0);
}

} // namespace ndframe
