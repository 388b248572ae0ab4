#include <cmath>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "ndframe/assembly/adaptive_samples.hpp"

namespace ndframe
{

namespace
{

using Function = std::function<double(const double* x)>;

struct Simplex
{
  int dim;
  std::vector<double> points; ///< dim + 1 in as many dimensions

  explicit Simplex(int dimension) : dim(dimension), points(std::size_t((dim + 1) * dim), 0.0)
  {
    for (int k = 0; k < dim; ++k)
      points[std::size_t((k + 1) * dim + k)] = 1.0;
  }

  Samples sample(const Function& f, double scale = 0.0) const
  {
    std::vector<const double*> vertices;
    for (int v = 0; v <= dim; ++v)
      vertices.push_back(points.data() + v * dim);
    return sampleAdaptively(dim, vertices.data(), dim, 1, scale,
                            [&](const double* x, double* value) { *value = f(x); });
  }
};

/// The mean value of f lambda_a^power by the samples.
double mean(const Samples& samples, int a, int power)
{
  double sum = 0.0;
  for (int q = 0; q < samples.rule.size(); ++q)
    sum += samples.rule.weights[std::size_t(q)] * samples.values[std::size_t(q)] *
           std::pow(samples.rule.point(q)[a], power);
  return sum;
}

double sumOfWeights(const Samples& samples)
{
  double sum = 0.0;
  for (const double weight : samples.rule.weights)
    sum += weight;
  return sum;
}

} // namespace

TEST(AdaptiveSamples, AreOneRuleForPolynomials)
{
  for (int dim = 1; dim <= 3; ++dim) {
    const Samples samples = Simplex(dim).sample([](const double* x) { return 2.0 + x[0] * x[0] * x[0]; });
    EXPECT_EQ(samples.pieces.size(), 1u);
    EXPECT_EQ(samples.uncertainty, 0.0);
    EXPECT_NEAR(sumOfWeights(samples), 1.0, 1e-14);
    // int x^n dx over the unit simplex times dim!: n! dim! / (n + dim)!
    const double exact[] = {2.0 + 1.0 / 4.0, 2.0 + 1.0 / 10.0, 2.0 + 1.0 / 20.0};
    EXPECT_NEAR(mean(samples, 1, 0), exact[dim - 1], 1e-14);
  }
}

TEST(AdaptiveSamples, IntegrateWhatIsNotPolynomialAgainstPolynomialsOfDegreeFour)
{
  struct Sample
  {
    Function f;
    std::function<double(int)> exact; ///< int_0^1 f(t) t^j dt
  };
  const double c = 0.3;
  const std::vector<Sample> samples = {
      {[c](const double* x) { return x[0] > c ? 1.0 : 0.0; },
       [c](int j) { return (1.0 - std::pow(c, j + 1)) / (j + 1); }},
      {[c](const double* x) { return std::max(0.0, x[0] - c); },
       [c](int j) { return (1.0 - std::pow(c, j + 2)) / (j + 2) - c * (1.0 - std::pow(c, j + 1)) / (j + 1); }},
      {[](const double* x) { return std::sqrt(x[0]); }, [](int j) { return 1.0 / (j + 1.5); }},
      {[](const double* x) { return 1.0 / (x[0] + 0.01); },
       [](int j) {
         double integral = std::log(101.0); // t^j / (t + a) = t^(j-1) - a t^(j-1) / (t + a)
         for (int k = 1; k <= j; ++k)
           integral = 1.0 / k - 0.01 * integral;
         return integral;
       }}};
  for (const auto& sample : samples) {
    const Samples result = Simplex(1).sample(sample.f);
    EXPECT_EQ(result.uncertainty, 0.0);
    EXPECT_GT(result.pieces.size(), 1u);
    for (int j = 0; j <= 4; ++j)
      EXPECT_NEAR(mean(result, 1, j), sample.exact(j), 2e-12 * result.scale);
  }
}

TEST(AdaptiveSamples, SeeAJumpWhereverItIs)
{
  test::Random random(5);
  for (int sample = 0; sample < 200; ++sample) { // many fall between the end of a piece and its first Gauss point
    const double c = random(0.0, 1.0);
    const Samples samples = Simplex(1).sample([c](const double* x) { return x[0] > c ? 1.0 : 0.0; });
    EXPECT_NEAR(mean(samples, 1, 0), 1.0 - c, 2e-12) << c;
    EXPECT_EQ(samples.uncertainty, 0.0);
  }
}

namespace
{

Function exponential(double k)
{
  return [k](const double* x) { return std::exp(k * x[0]); };
}

/// dim int (1-x)^(dim-1) e^(kx).
double meanOfExponential(int dim, double k)
{
  const double e = std::exp(k);
  return dim == 2 ? 2.0 * (e - 1.0 - k) / (k * k) : 3.0 * (2.0 * e - k * k - 2.0 * k - 2.0) / (k * k * k);
}

} // namespace

TEST(AdaptiveSamples, ResolveSmoothFunctionsOnTrianglesAndTetrahedra)
{
  for (const auto& [dim, k] : {std::pair(2, 3.0), std::pair(3, 0.2)}) {
    const Samples samples = Simplex(dim).sample(exponential(k));
    EXPECT_EQ(samples.uncertainty, 0.0);
    EXPECT_NEAR(mean(samples, 1, 0), meanOfExponential(dim, k), 1e-12 * std::exp(k));
  }
}

TEST(AdaptiveSamples, AreFewInTetrahedraAndSayHowUncertain)
{
  const Samples samples = Simplex(3).sample(exponential(3.0));
  const double error = std::abs(mean(samples, 1, 0) - meanOfExponential(3, 3.0));
  EXPECT_LE(samples.pieces.size(), 4u);
  EXPECT_LT(error, 1e-9);
  EXPECT_GT(samples.uncertainty, error);
}

TEST(AdaptiveSamples, SayHowUncertainTheyAreAtAJumpInsideATriangle)
{
  const Samples samples = Simplex(2).sample([](const double* x) { return x[0] > 0.3 ? 1.0 : -1.0; });
  const double error = std::abs(mean(samples, 0, 0) + 0.02);
  EXPECT_GT(error, 1e-12);
  EXPECT_GT(samples.uncertainty, error);
  EXPECT_LT(samples.uncertainty, 1.0);
}

TEST(AdaptiveSamples, DoNotResolveWhatIsSmallAgainstTheScale)
{
  const Function noise = [](const double* x) { return x[0] > 0.3 ? 1e-15 : 0.0; };
  EXPECT_GT(Simplex(1).sample(noise).pieces.size(), 10u);
  EXPECT_EQ(Simplex(1).sample(noise, 1.0).pieces.size(), 1u);
}

TEST(AdaptiveSamples, DoNotDependOnUnits)
{
  const auto rough = [](double length, double force) {
    Simplex edge(1);
    edge.points[1] = length;
    return edge.sample([=](const double* x) { return force * std::abs(x[0] / length - 0.4); });
  };
  const Samples here = rough(1.0, 1.0), there = rough(1e-9, 1e30);
  ASSERT_EQ(here.rule.size(), there.rule.size());
  for (int q = 0; q < here.rule.size(); ++q)
    EXPECT_NEAR(here.values[std::size_t(q)], 1e-30 * there.values[std::size_t(q)], 1e-14);
}

} // namespace ndframe
