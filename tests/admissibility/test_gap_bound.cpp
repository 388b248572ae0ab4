#include <cmath>

#include <gmock/gmock.h>

#include "admissibility/sample_gap.hpp"
#include "ndframe/admissibility/gap_bound.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

using test::Gap;

GapBound bound(const test::ContactStrip& strip, const Gap& gap, int degree = 3)
{
  return boundGap(strip.bodyPointers(), strip.patches, degree, gap.on(strip));
}

/// g_h at t on a facet.
double lowered(const GapBound& gap, const test::ContactStrip& strip, std::size_t patch, double t)
{
  const std::size_t size = gap.bernstein.size() / strip.patches.size();
  const double *b = gap.bernstein.data() + patch * size, s = 1.0 - t;
  return size == 2 ? s * b[0] + t * b[1] : s * s * b[0] + 2.0 * s * t * b[2] + t * t * b[1];
}

/// The largest and smallest g - g_h over many points of all facets.
std::array<double, 2> clearances(const GapBound& gap, const test::ContactStrip& strip, const Gap& g)
{
  double least = 1e300, most = -1e300;
  for (std::size_t f = 0; f < strip.patches.size(); ++f)
    for (int i = 0; i <= 500; ++i) {
      const double t = i / 500.0, clearance = g(strip.point(f, t)[0]) - lowered(gap, strip, f, t);
      least = std::min(least, clearance);
      most = std::max(most, clearance);
    }
  return {least, most};
}

const std::vector<Gap>& roughGaps()
{
  static const std::vector<Gap> gaps = {"0.1*exp(3*x)",
                                        "0.02 + 0.01*sin(20*x)",
                                        "abs(x - 0.43)",
                                        "0.5 - sqrt(0.25 - 0.2*x^2)",
                                        "x > 0.57 ? 0.1*x^2 : 0.05",
                                        "x^1.5",
                                        "sqrt(x)",
                                        "abs(x^2 - 0.2)",
                                        "x^2 > 0.3 ? 0.1 : 0.2",
                                        "0.1 - 0.09*exp(-((x - 0.3217)/0.001)^2)",
                                        "0.05*(1 + tanh((x - 0.61)/1e-4))",
                                        "0.2 - 0.1*(x > 0.401)*(x < 0.402)"};
  return gaps;
}

} // namespace

struct GapBounds : testing::TestWithParam<int>
{
  int order = GetParam();
  test::ContactStrip strip = test::contactStrip(4, order);
};
INSTANTIATE_TEST_SUITE_P(Orders, GapBounds, testing::Values(1, 2), testing::PrintToStringParamName());

TEST_P(GapBounds, LieBelowRoughGapsEverywhere)
{
  for (std::size_t g = 0; g < roughGaps().size(); ++g)
    EXPECT_GE(clearances(bound(strip, roughGaps()[g]), strip, roughGaps()[g])[0], -1e-12) << roughGaps()[g].text();
}

TEST_P(GapBounds, StayCloseToSmoothGaps)
{
  const Gap gap = "0.1*exp(x)";
  double previous = 1e300;
  for (const int patches : {4, 8}) {
    const auto finer = test::contactStrip(patches, order);
    const double farthest = clearances(bound(finer, gap), finer, gap)[1];
    EXPECT_LT(farthest, order == 1 ? 0.3 / (patches * patches) : 0.06 / (patches * patches * patches));
    EXPECT_LT(farthest, previous / (order == 1 ? 3.5 : 7.0));
    previous = farthest;
  }
}

TEST_P(GapBounds, KeepPolynomialsOfTheOrder)
{
  for (const Gap& gap : {Gap("0"), Gap("0.3"), Gap(order == 1 ? "0.1 + x" : "0.2 - x + 2*x^2")}) {
    const auto result = bound(strip, gap);
    const auto [least, most] = clearances(result, strip, gap);
    EXPECT_NEAR(least, 0.0, 1e-15);
    EXPECT_NEAR(most, 0.0, 1e-15);
    EXPECT_EQ(result.caveat, "");
  }
}

TEST_P(GapBounds, KeepTheValuesAtTheVerticesOfQuadraticBodies)
{
  if (order == 1)
    return;
  for (const Gap& gap : {Gap("0.1*exp(3*x)"), Gap("0.02 + 0.01*sin(20*x)"), Gap("abs(x - 0.43)"),
                         Gap("0.5 - sqrt(0.25 - 0.2*x^2)"), Gap("x > 0.57 ? 0.1*x^2 : 0.05")})
  {
    const GapBound result = bound(strip, gap);
    for (std::size_t f = 0; f < strip.patches.size(); ++f)
      for (const double t : {0.0, 1.0})
        EXPECT_EQ(lowered(result, strip, f, t), gap(strip.point(f, t)[0]));
  }
}

TEST_P(GapBounds, KnowTheMomentsOfTheGapItself)
{
  const Gap gap = "0.1*exp(3*x)";
  const GapBound result = bound(strip, gap, 2);
  const MomentBasis basis = facetBasis(2, 2);
  const QuadratureRule rule = simplexRule(1, 24);
  for (std::size_t f = 0; f < strip.patches.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      double exact = 0.0, L[3];
      for (int q = 0; q < rule.size(); ++q) {
        basis.values(rule.point(q), L);
        exact +=
            strip.patches[f].measure * rule.weights[std::size_t(q)] * L[k] * gap(strip.point(f, rule.point(q)[1])[0]);
      }
      EXPECT_NEAR(result.moments[f * 3 + std::size_t(k)], exact, 1e-14);
    }
}

TEST_P(GapBounds, ScaleWithTheirUnit)
{
  const Gap gap = "0.1*exp(3*x)";
  const GapBound here = bound(strip, gap), there = bound(strip, "1e-20*0.1*exp(3*x)");
  for (std::size_t i = 0; i < here.bernstein.size(); ++i)
    EXPECT_NEAR(there.bernstein[i], 1e-20 * here.bernstein[i], 1e-32);
}

} // namespace ndframe
