#include <cmath>

#include <gmock/gmock.h>

#include "ndframe/fem/quadrature.hpp"
#include "ndframe/recovery/gap_bound.hpp"
#include "recovery/contact_strip.hpp"

namespace ndframe
{

namespace
{

using Gap = std::function<double(double x)>;

FacetGap along(const Gap& gap)
{
  return [gap](int, const double* point) { return gap(point[0]); };
}

GapBound bound(const test::ContactStrip& strip, const Gap& gap, int degree = 3)
{
  return boundGap(strip.bodyPointers(), strip.facets, degree, along(gap));
}

/// g_h at t on a facet.
double lowered(const GapBound& gap, const test::ContactStrip& strip, std::size_t facet, double t)
{
  const std::size_t size = gap.bernstein.size() / strip.facets.size();
  const double *b = gap.bernstein.data() + facet * size, s = 1.0 - t;
  return size == 2 ? s * b[0] + t * b[1] : s * s * b[0] + 2.0 * s * t * b[1] + t * t * b[2];
}

/// The largest and smallest g - g_h over many points of all facets.
std::array<double, 2> clearances(const GapBound& gap, const test::ContactStrip& strip, const Gap& g)
{
  double least = 1e300, most = -1e300;
  for (std::size_t f = 0; f < strip.facets.size(); ++f)
    for (int i = 0; i <= 500; ++i) {
      const double t = i / 500.0, clearance = g(strip.point(f, t)[0]) - lowered(gap, strip, f, t);
      least = std::min(least, clearance);
      most = std::max(most, clearance);
    }
  return {least, most};
}

const std::vector<Gap>& roughGaps()
{
  static const std::vector<Gap> gaps = {[](double x) { return 0.1 * std::exp(3.0 * x); },
                                        [](double x) { return 0.02 + 0.01 * std::sin(20.0 * x); },
                                        [](double x) { return std::abs(x - 0.43); },
                                        [](double x) { return 0.5 - std::sqrt(0.25 - 0.2 * x * x); },
                                        [](double x) { return x > 0.57 ? 0.1 * x * x : 0.05; },
                                        [](double x) { return std::pow(x, 1.5); }};
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
    EXPECT_GE(clearances(bound(strip, roughGaps()[g]), strip, roughGaps()[g])[0], -1e-12) << "gap " << g;
}

TEST_P(GapBounds, StayCloseToSmoothGaps)
{
  const Gap gap = [](double x) { return 0.1 * std::exp(x); };
  double previous = 1e300;
  for (const int facets : {4, 8}) {
    const auto finer = test::contactStrip(facets, order);
    const double farthest = clearances(bound(finer, gap), finer, gap)[1];
    EXPECT_LT(farthest, order == 1 ? 0.3 / (facets * facets) : 0.06 / (facets * facets * facets));
    EXPECT_LT(farthest, previous / (order == 1 ? 3.5 : 7.0));
    previous = farthest;
  }
}

TEST_P(GapBounds, KeepPolynomialsOfTheOrder)
{
  for (const Gap& gap : {Gap([](double) { return 0.0; }), Gap([](double) { return 0.3; }),
                         Gap([this](double x) { return order == 1 ? 0.1 + x : 0.2 - x + 2.0 * x * x; })})
  {
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
  for (const Gap& gap : roughGaps()) {
    const GapBound result = bound(strip, gap);
    for (std::size_t f = 0; f < strip.facets.size(); ++f)
      for (const double t : {0.0, 1.0})
        EXPECT_EQ(lowered(result, strip, f, t), gap(strip.point(f, t)[0]));
  }
}

TEST_P(GapBounds, KnowTheMomentsOfTheGapItself)
{
  const Gap gap = [](double x) { return 0.1 * std::exp(3.0 * x); };
  const GapBound result = bound(strip, gap, 2);
  const MomentBasis basis = facetBasis(2, 2);
  const QuadratureRule rule = simplexRule(1, 24);
  for (std::size_t f = 0; f < strip.facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      double exact = 0.0, L[3];
      for (int q = 0; q < rule.size(); ++q) {
        basis.values(rule.point(q), L);
        exact +=
            strip.facets[f].measure * rule.weights[std::size_t(q)] * L[k] * gap(strip.point(f, rule.point(q)[1])[0]);
      }
      EXPECT_NEAR(result.moments[f * 3 + std::size_t(k)], exact, 1e-14);
    }
}

TEST_P(GapBounds, ScaleWithTheirUnit)
{
  const Gap gap = [](double x) { return 0.1 * std::exp(3.0 * x); };
  const GapBound here = bound(strip, gap), there = bound(strip, [&](double x) { return 1e-20 * gap(x); });
  for (std::size_t i = 0; i < here.bernstein.size(); ++i)
    EXPECT_NEAR(there.bernstein[i], 1e-20 * here.bernstein[i], 1e-32);
}

} // namespace ndframe
