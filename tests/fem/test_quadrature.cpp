#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

struct Case
{
  int dim, degree;
  bool isCompact = false;
};

std::vector<Case> allCases()
{
  std::vector<Case> cases;
  for (int dim = 1; dim <= 3; ++dim)
    for (int degree = 0; degree <= 10; ++degree)
      cases.push_back({dim, degree});
  for (int dim = 2; dim <= 3; ++dim)
    for (int degree = 1; degree <= (dim == 2 ? 31 : 17); ++degree) // one beyond the tables
      cases.push_back({dim, degree, true});
  return cases;
}

std::string caseName(const testing::TestParamInfo<Case>& test)
{
  return "Dim" + std::to_string(test.param.dim) + "Degree" + std::to_string(test.param.degree) +
         (test.param.isCompact ? "Compact" : "");
}

/// Mean of lambda_1^a lambda_2^b lambda_3^c over the simplex: dim! a! b! c! / (a + b + c + dim)!.
double meanOfMonomial(int dim, int a, int b, int c)
{
  return std::tgamma(dim + 1) * std::tgamma(a + 1) * std::tgamma(b + 1) * std::tgamma(c + 1) /
         std::tgamma(a + b + c + dim + 1);
}

double ruleOnMonomial(const QuadratureRule& rule, int a, int b, int c)
{
  double sum = 0.0;
  for (int q = 0; q < rule.size(); ++q) {
    const double* lambda = rule.point(q);
    sum += rule.weights[std::size_t(q)] * std::pow(lambda[1], a) * (b == 0 ? 1.0 : std::pow(lambda[2], b)) *
           (c == 0 ? 1.0 : std::pow(lambda[3], c));
  }
  return sum;
}

} // namespace

struct SimplexRule : testing::TestWithParam<Case>
{
  QuadratureRule rule = GetParam().isCompact ? compactRule(GetParam().dim, GetParam().degree)
                                             : simplexRule(GetParam().dim, GetParam().degree);
};

TEST_P(SimplexRule, IsExactForEveryMonomialUpToItsDegree)
{
  const int dim = GetParam().dim, degree = GetParam().degree;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; b <= (dim >= 2 ? degree - a : 0); ++b)
      for (int c = 0; c <= (dim == 3 ? degree - a - b : 0); ++c) {
        const double exact = meanOfMonomial(dim, a, b, c);
        EXPECT_NEAR(ruleOnMonomial(rule, a, b, c), exact, 1e-13 * exact) << a << b << c;
      }
}

TEST_P(SimplexRule, HasPositiveWeightsThatAddUpToOne)
{
  for (const double weight : rule.weights)
    EXPECT_GT(weight, 0.0);
  EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 1.0, 1e-14);
}

TEST_P(SimplexRule, HasItsPointsInside)
{
  for (int q = 0; q < rule.size(); ++q) {
    const double* lambda = rule.point(q);
    EXPECT_NEAR(std::accumulate(lambda, lambda + rule.dim + 1, 0.0), 1.0, 1e-15);
    for (int k = 0; k <= rule.dim; ++k)
      EXPECT_GT(lambda[k], 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, SimplexRule, testing::ValuesIn(allCases()), caseName);

TEST(SimplexRuleSize, IsDimPlusOneUpToDegreeTwo)
{
  for (int dim = 1; dim <= 3; ++dim)
    EXPECT_EQ(simplexRule(dim, 2).size(), dim + 1);
}

/// Numbers of points in Xiao and Gimbutas (2010).
TEST(SimplexRuleSize, OfCompactRulesIsThatOfTheTables)
{
  EXPECT_EQ(compactRule(2, 9).size(), 19);
  EXPECT_EQ(compactRule(2, 17).size(), 60);
  EXPECT_EQ(compactRule(3, 11).size(), 95);
  EXPECT_EQ(compactRule(3, 15).size(), 214);
}

TEST(SimplexRuleSize, UnknownKindsAreABug)
{
  EXPECT_THROW(simplexRule(4, 1), InternalError);
  EXPECT_THROW(simplexRule(0, 1), InternalError);
  EXPECT_THROW(simplexRule(2, -1), InternalError);
  EXPECT_THROW(compactRule(1, 4), InternalError);
}

} // namespace ndframe
