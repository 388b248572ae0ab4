// Integrals of data by their samples against closed forms: whatever the data, they are right or said to be uncertain.

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"
#include "sampling/sample_means.hpp"

namespace ndframe
{

namespace
{

struct Simplex
{
  int dim;
  std::vector<double> points; ///< dim + 1 in as many dimensions

  explicit Simplex(int dimension) : dim(dimension), points(std::size_t((dim + 1) * dim), 0.0)
  {
    for (int k = 0; k < dim; ++k)
      points[std::size_t((k + 1) * dim + k)] = 1.0;
  }

  Samples sample(const std::string& text, double scale = 0.0) const
  {
    DataSampler::Vertices vertices{};
    for (int v = 0; v <= dim; ++v)
      vertices[std::size_t(v)] = points.data() + v * dim;
    const auto refuse = [](const double*, int, double) { throw std::domain_error("not finite"); };
    DataSampler sampler({{std::make_shared<const ExpressionTree>(text), refuse}}, dim);
    const double found = sampler.scaleOn([&](const DataSampler::Visit& visit) { visit(dim, vertices); });
    return sampler.sample(dim, vertices, scale > 0.0 ? scale : found);
  }
};

double sumOfWeights(const Samples& samples)
{
  double sum = 0.0;
  for (const double weight : samples.rule.weights)
    sum += weight;
  return sum;
}

/// A function of one coordinate with its mean value over [0, 1].
struct Known
{
  std::string text;
  double mean;
  double scale; ///< largest absolute value
};

/// The kinds of data that points between which nobody looks may miss, at a random place with a random width.
Known randomNeedle(test::Random& random)
{
  const double c = random(0.0, 1.0), w = std::pow(10.0, random(-4.0, -0.3));
  const auto number = [](double value) { return fmt::format("({:.17g})", value); };
  const std::string X = "(x - " + number(c) + ")", W = number(w);
  const double left = std::max(0.0, c - w), right = std::min(1.0, c + w);
  switch (int(random(0.0, 5.999))) {
  case 0:
    return {"1 + 100*exp(-(" + X + "/" + W + ")^2)",
            1.0 + 50.0 * std::sqrt(M_PI) * w * (std::erf((1.0 - c) / w) + std::erf(c / w)), 101.0};
  case 1:
    return {"1 + 10*(" + X + " > -" + W + ")*(" + X + " < " + W + ")", 1.0 + 10.0 * (right - left), 11.0};
  case 2:
    return {"abs(" + X + ")", 0.5 * (c * c + (1.0 - c) * (1.0 - c)), std::max(c, 1.0 - c)};
  case 3:
    return {"max(0, 1 - abs(" + X + ")/" + W + ")",
            [&] {
              const auto F = [&](double s) { return s - s * s / (2.0 * w); }; // int_0^s (1 - t / w)
              return F(c - left) + F(right - c);
            }(),
            1.0};
  case 4:
    return {"tanh(" + X + "/" + W + ")",
            [&] {
              const auto F = [&](double s) { return s + w * std::log1p(std::exp(-2.0 * s / w)); }; // + constant
              return F(1.0 - c) - F(c);
            }(),
            1.0};
  default:
    return {"sqrt(abs(" + X + "))", 2.0 / 3.0 * (std::pow(c, 1.5) + std::pow(1.0 - c, 1.5)), 1.0};
  }
}

} // namespace

TEST(AdaptiveSamples, AreOneExactRuleForPolynomials)
{
  for (int dim = 1; dim <= 3; ++dim) {
    const Samples samples = Simplex(dim).sample("2 + x^3");
    EXPECT_EQ(samples.pieces.size(), 1u);
    EXPECT_EQ(samples.uncertainty, 0.0);
    EXPECT_EQ(samples.spread, 0.0);
    EXPECT_NEAR(sumOfWeights(samples), 1.0, 1e-14);
    // int x^n dx over the unit simplex times dim!: n! dim! / (n + dim)!
    const double exact[] = {2.0 + 1.0 / 4.0, 2.0 + 1.0 / 10.0, 2.0 + 1.0 / 20.0};
    EXPECT_NEAR(mean(samples, 1, 0), exact[dim - 1], 1e-14);
  }
}

TEST(AdaptiveSamples, IntegratePolynomialsOfEachDegreeAgainstThoseOfDegreeFiveLessTheDimension)
{
  for (int dim = 1; dim <= 3; ++dim)
    for (int degree = 1; degree <= (dim == 3 ? 6 : 9); ++degree)
      for (int ofY = 0; ofY <= (dim == 1 ? 0 : degree); ++ofY) {
        const Samples samples = Simplex(dim).sample(fmt::format("x^{}*y^{}", degree - ofY, ofY));
        ASSERT_EQ(samples.pieces.size(), 1u);
        EXPECT_EQ(samples.uncertainty + samples.spread, 0.0);
        for (const double weight : samples.rule.weights)
          EXPECT_GT(weight, 0.0);
        for (const double lambda : samples.rule.lambda)
          EXPECT_GT(lambda, 0.0);
        for (int power = 0; power <= 5 - dim; ++power)
          EXPECT_NEAR(mean(samples, 1, power), meanOfMonomial(dim, degree - ofY + power, ofY), 2e-16);
      }
}

TEST(AdaptiveSamples, TakeNoMorePointsThanTheDegreeOfAPolynomialNeeds)
{
  const auto points = [](const char* text) { return Simplex(2).sample(text).rule.size(); };
  EXPECT_EQ(points("1 + 2*x - y"), 6);
  EXPECT_EQ(points("x*y"), 7);
  EXPECT_EQ(points("x*y^2"), 12);
  EXPECT_EQ(points("x^2*y^2"), 16);
}

TEST(AdaptiveSamples, IntegrateWhatIsNotPolynomialAgainstPolynomialsOfDegreeFour)
{
  struct Sample
  {
    std::string text;
    std::function<double(int)> exact; ///< int_0^1 f(t) t^j dt
  };
  const double c = 0.3;
  const std::vector<Sample> samples = {
      {"x > 0.3", [c](int j) { return (1.0 - std::pow(c, j + 1)) / (j + 1); }},
      {"max(0, x - 0.3)",
       [c](int j) { return (1.0 - std::pow(c, j + 2)) / (j + 2) - c * (1.0 - std::pow(c, j + 1)) / (j + 1); }},
      {"x^2 > 0.09", [c](int j) { return (1.0 - std::pow(c, j + 1)) / (j + 1); }}, // located, not cut
      {"sqrt(x)", [](int j) { return 1.0 / (j + 1.5); }},
      {"1/(x + 0.01)", [](int j) {
         double integral = std::log(101.0); // t^j / (t + a) = t^(j-1) - a t^(j-1) / (t + a)
         for (int k = 1; k <= j; ++k)
           integral = 1.0 / k - 0.01 * integral;
         return integral;
       }}};
  for (const auto& sample : samples) {
    const Samples result = Simplex(1).sample(sample.text);
    EXPECT_TRUE(result.areCertain()) << sample.text;
    EXPECT_GT(result.pieces.size(), 1u);
    for (int j = 0; j <= 4; ++j)
      EXPECT_NEAR(mean(result, 1, j), sample.exact(j), 2e-12 * result.scale) << sample.text;
  }
}

TEST(AdaptiveSamples, SeeNeedlesWhereverTheyAre)
{
  test::Random random(5);
  for (int sample = 0; sample < 1000; ++sample) {
    const Known f = randomNeedle(random);
    const Samples samples = Simplex(1).sample(f.text);
    EXPECT_TRUE(samples.areCertain()) << f.text;
    EXPECT_NEAR(mean(samples, 1, 0), f.mean, 1e-11 * f.scale) << f.text;
    EXPECT_NEAR(sumOfWeights(samples), 1.0, 1e-12);
  }
}

TEST(AdaptiveSamples, SeeNeedlesInTrianglesAndTetrahedraOrSaySo)
{
  test::Random random(6);
  int certain = 0;
  for (const int dim : {2, 3})
    for (int sample = 0; sample < (dim == 2 ? 60 : 10); ++sample) {
      const Known f = randomNeedle(random);
      // over the simplex x + y + .. <= 1 the mean of f(x) is dim int f (1 - x)^(dim - 1): compare with the edge's
      // samples
      const Samples samples = Simplex(dim).sample(f.text), edge = Simplex(1).sample(f.text);
      const double exact = dim * mean(edge, 0, dim - 1), scale = samples.scale;
      EXPECT_LE(std::abs(mean(samples, 1, 0) - exact), (samples.uncertainty + 1e-11) * scale) << f.text;
      certain += samples.areCertain();
    }
  EXPECT_EQ(certain, 70);
}

TEST(AdaptiveSamples, CutTrianglesAndTetrahedraWhereAffineFunctionsSwitch)
{
  for (const int dim : {2, 3}) {
    const Samples jump = Simplex(dim).sample("x + 2*y < 0.7 ? 3 : -1"), both = Simplex(dim).sample("max(x, y)");
    EXPECT_LT(jump.pieces.size(), 8u);
    EXPECT_EQ(jump.uncertainty, 0.0);
    EXPECT_TRUE(both.areCertain());
    // int over the triangle of max(x, y) = 1/4, of the tetrahedron 1/16 (moments of order statistics)
    EXPECT_NEAR(mean(both, 0, 0), dim == 2 ? 0.5 : 0.375, 1e-12);
  }
  // the triangle is cut off at x + 2 y = 0.7: the corner's area 0.7 * 0.35 / 2
  EXPECT_NEAR(mean(Simplex(2).sample("x + 2*y < 0.7 ? 3 : -1"), 0, 0), -1.0 + 4.0 * 0.7 * 0.35, 1e-13);
}

/// On an edge along which a comparison holds with equality the points must agree with it, or nobody is certain.
TEST(AdaptiveSamples, AreCertainWhereDataSwitchAlongAnEdgeOnlyIfAllPointsAgree)
{
  const auto along = [](std::array<double, 4> ends, const std::string& text) {
    DataSampler sampler({{std::make_shared<const ExpressionTree>(text), {}}}, 2);
    return sampler.sample(1, {ends.data(), ends.data() + 2, nullptr, nullptr}, 1.0);
  };
  test::Random random(7);
  for (int sample = 0; sample < 200; ++sample) {
    const double c = random(0.1, 9.0);
    const auto number = fmt::format("{:.17g}", c);
    const Samples upright = along({c, 0.3, c, 1.7}, "x <= " + number);
    EXPECT_TRUE(upright.areCertain());
    EXPECT_NEAR(mean(upright, 0, 0), 1.0, 1e-14);
    EXPECT_FALSE(along({0.0, c, c, 0.0}, "x + y <= " + number).areCertain());
  }
}

TEST(AdaptiveSamples, SayHowUncertainTheyAreAtACurvedJump)
{
  const Samples samples = Simplex(2).sample("x^2 + y^2 < 0.25");
  const double error = std::abs(mean(samples, 0, 0) - 2.0 * M_PI / 16.0);
  EXPECT_FALSE(samples.areCertain());
  EXPECT_LE(error, samples.uncertainty);
  EXPECT_LT(samples.uncertainty, 0.01);
}

TEST(AdaptiveSamples, SayThatDataWithoutBoundAreUncertain)
{
  for (const char* text : {"1/x", "1/sqrt(x)", "log(x)", "1/(x - 0.3)^2"})
    try {
      EXPECT_FALSE(Simplex(1).sample(text).areCertain()) << text;
    } catch (const std::domain_error&) { // a point came so close that the value is infinite
    }
}

namespace
{

/// dim int (1-x)^(dim-1) e^(kx).
double meanOfExponential(int dim, double k)
{
  const double e = std::exp(k);
  return dim == 2 ? 2.0 * (e - 1.0 - k) / (k * k) : 3.0 * (2.0 * e - k * k - 2.0 * k - 2.0) / (k * k * k);
}

} // namespace

TEST(AdaptiveSamples, ResolveSmoothFunctionsOnTrianglesAndTetrahedra)
{
  for (const auto& [dim, k] : {std::pair(2, 3.0), std::pair(3, 1.0)}) {
    const Samples samples = Simplex(dim).sample(fmt::format("exp({}*x)", k));
    EXPECT_TRUE(samples.areCertain());
    EXPECT_NEAR(mean(samples, 1, 0), meanOfExponential(dim, k), 1e-12 * std::exp(k));
  }
}

TEST(AdaptiveSamples, DoNotResolveWhatIsSmallAgainstTheScale)
{
  EXPECT_GT(Simplex(1).sample("1e-15*(x^2 > 0.09)").pieces.size(), 10u);
  EXPECT_EQ(Simplex(1).sample("1e-15*(x^2 > 0.09)", 1.0).pieces.size(), 1u);
}

TEST(AdaptiveSamples, DoNotDependOnUnits)
{
  const auto rough = [](double length, double force) {
    Simplex edge(1);
    edge.points[1] = length;
    return edge.sample(fmt::format("{:g}*abs((x/{:g})^2 - 0.16)", force, length));
  };
  const Samples here = rough(1.0, 1.0), there = rough(1e-9, 1e30);
  ASSERT_EQ(here.rule.size(), there.rule.size());
  for (int q = 0; q < here.rule.size(); ++q)
    EXPECT_NEAR(here.values[std::size_t(q)], 1e-30 * there.values[std::size_t(q)], 1e-14);
}

TEST(AdaptiveSamples, FindTheScaleOfNarrowData)
{
  Simplex edge(1);
  DataSampler sampler({{std::make_shared<const ExpressionTree>("7*exp(-((x - 0.3217)/1e-5)^2)"), {}}}, 1);
  const double ends[] = {0.0, 0.25, 0.5, 0.75, 1.0};
  const double scale = sampler.scaleOn([&](const DataSampler::Visit& visit) {
    for (int e = 0; e < 4; ++e)
      visit(1, {ends + e, ends + e + 1, nullptr, nullptr});
  });
  EXPECT_GE(scale, 3.5);
  EXPECT_LE(scale, 7.0);
}

} // namespace ndframe
