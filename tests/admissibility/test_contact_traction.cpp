#include <gtest/gtest.h>

#include "admissibility/sample_chains.hpp"
#include "ndframe/admissibility/sign_conditions.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

using test::Chain;

/// t of a body's patch at lambda (ascending vertices of that body), from the sum of its shares in global axes.
std::array<double, 2> fromShares(const Vector& shares, int patch, int degree, double measure, double lambda)
{
  const auto modes = std::size_t(degree + 1);
  const double barycentric[2] = {1.0 - lambda, lambda};
  Vector L(modes);
  facetBasis(2, degree).values(barycentric, L.data());
  std::array<double, 2> t{};
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t i = 0; i < 2; ++i)
        t[i] += shares[((std::size_t(patch) * 2 + a) * modes + k) * 2 + i] * L[k] / measure;
  return t;
}

} // namespace

TEST(ContactTraction, NodalValuesAreReproducedByTheirShares)
{
  std::mt19937 random(1);
  for (const int order : {1, 2})
    for (int degree = order; degree <= 3; ++degree) {
      const Chain chain = test::straightChain(test::randomLengths(3, random), order);
      const Vector nodal = test::randomNodes(chain.numNodes(), random);
      const ContactTraction t = tractionFromNodes(chain.patches, nodal, order, degree);
      for (std::size_t f = 0; f < 3; ++f)
        for (const double lambda : {0.0, 0.3, 1.0})
          EXPECT_NEAR(test::valueAt(chain.patches[f], t, int(f), lambda),
                      test::valueAt(chain.patches[f], nodal, order, lambda), 1e-13);
    }
}

TEST(ContactTraction, SharesOfOrderTwoAreThoseOfTheSharesClass)
{
  // t linear: its shares follow from ofLinear
  const Chain chain = test::straightChain({0.7}, 2);
  const Shares shares(facetBasis(2, 3), 2);
  const ContactTraction t = tractionFromNodes(chain.patches, {-1.0, -3.0, -2.0}, 2, 3);
  for (int a = 0; a < 2; ++a)
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(t.shares[std::size_t(a * 4 + k)],
                  0.7 * (-1.0 * shares.ofLinear(a, 0)[k] - 3.0 * shares.ofLinear(a, 1)[k]), 1e-15);
}

TEST(ContactTraction, SharesOfOrderOneActAtTheirVertices)
{
  const Chain chain = test::straightChain({0.7}, 1);
  const ContactTraction t = tractionFromNodes(chain.patches, {-1.0, -4.0}, 1, 2);
  const MomentBasis basis = facetBasis(2, 2);
  const QuadratureRule rule = simplexRule(1, 4);
  for (int a = 0; a < 2; ++a) {
    double force = 0.0, position = 0.0, L[3];
    for (int q = 0; q < rule.size(); ++q) {
      basis.values(rule.point(q), L);
      for (int k = 0; k < 3; ++k) {
        const double value = rule.weights[std::size_t(q)] * t.shares[std::size_t(a * 3 + k)] * L[k];
        force += value, position += value * rule.point(q)[1];
      }
    }
    EXPECT_NEAR(force, 0.7 * (a == 0 ? -1.0 / 3 - 4.0 / 6 : -1.0 / 6 - 4.0 / 3), 1e-15);
    EXPECT_NEAR(position, a * force, 1e-15);
  }
}

TEST(ContactTraction, BernsteinCoefficientsReproduceThePolynomial)
{
  const double lambda = 0.3, mu = 0.7;
  const std::vector<std::vector<double>> bernstein = {
      {mu, lambda},
      {mu * mu, 2 * mu * lambda, lambda * lambda},
      {mu * mu * mu, 3 * mu * mu * lambda, 3 * mu * lambda * lambda, lambda * lambda * lambda}};
  for (int degree = 1; degree <= 3; ++degree) {
    const DenseMatrix C = bernsteinOfMoments(2, degree);
    const double barycentric[2] = {mu, lambda};
    Vector L(std::size_t(degree + 1));
    facetBasis(2, degree).values(barycentric, L.data());
    for (int k = 0; k <= degree; ++k)
      EXPECT_NEAR(dot(C.column(k), bernstein[std::size_t(degree - 1)]), L[std::size_t(k)], 1e-14);
  }
}

TEST(ContactTraction, TheLargestBernsteinCoefficientIsThatOfAllFacets)
{
  const Chain chain = test::straightChain({2.0, 0.5}, 2);
  // vertices 0, 1, 2; middles 3, 4: coefficients -1, 2 (-1) + 1.5 = -0.5, -2 and -2, 2 (-1.5) + 2.5 = -0.5, -3
  EXPECT_NEAR(largestBernstein(tractionFromNodes(chain.patches, {-1, -2, -3, -1, -1.5}, 2, 2), chain.patches), -0.5,
              1e-14);
  // raised to degree 3 the coefficients move towards the polynomial
  EXPECT_NEAR(largestBernstein(tractionFromNodes(chain.patches, {-1, -2, -3, -1, -1.5}, 2, 3), chain.patches), -2.0 / 3,
              1e-14);
}

TEST(ContactTraction, SignsAreShownByTheCoefficientsOfBothHalves)
{
  for (int degree = 1; degree <= 3; ++degree) {
    const DenseMatrix conditions = signConditions(2, degree), whole = bernsteinOfMoments(2, degree);
    ASSERT_EQ(conditions.rows(), 2 * (degree + 1));
    std::mt19937 random(degree);
    for (int trial = 0; trial < 50; ++trial) {
      const Vector moments = test::randomNodes(degree + 1, random), b = multiply(whole, moments);
      const Vector halves = multiply(conditions, moments);
      for (int half = 0; half < 2; ++half)
        for (const double s : {0.0, 0.2, 0.7, 1.0}) {
          const auto bernstein = [&](const double* coefficients, double x) {
            double value = 0.0, binomial = 1.0;
            for (int i = 0; i <= degree; binomial *= double(degree - i) / (i + 1), ++i)
              value += binomial * coefficients[i] * std::pow(x, i) * std::pow(1.0 - x, degree - i);
            return value;
          };
          EXPECT_NEAR(bernstein(halves.data() + half * (degree + 1), s), bernstein(b.data(), 0.5 * (half + s)), 1e-12);
        }
      EXPECT_LE(*std::max_element(halves.begin(), halves.end()), *std::max_element(b.begin(), b.end()) + 1e-13);
    }
  }
}

TEST(ContactTraction, ASteepPressureIsSeenToPressAndATensionInTheMiddleIsSeen)
{
  const Chain chain = test::straightChain({1.0}, 2);
  // coefficients -10, 2 (-2.5) + 5.5 = 0.5, -1: it presses, which those of the whole edge do not show
  const ContactTraction steep = tractionFromNodes(chain.patches, {-10, -1, -2.5}, 2, 2);
  EXPECT_NEAR(largestBernstein(steep, chain.patches), 0.5, 1e-13);
  EXPECT_NEAR(largestSign(steep, chain.patches), -0.25, 1e-13); // (0.5 - 1) / 2
  EXPECT_NEAR(largestSign(tractionFromNodes(chain.patches, {-1, -1, 0.01}, 2, 2), chain.patches), 0.01, 1e-13);
}

TEST(ContactTraction, BothBodiesFeelTheSameTractionInOppositeDirections)
{
  std::mt19937 random(2);
  for (const bool reversed : {false, true})
    for (const int degree : {2, 3}) {
      Chain chain = test::straightChain({0.4, 0.9}, 2);
      for (ContactPatch& patch : chain.patches) {
        patch.sides[1].places = reversed ? std::array{1, 0, 2} : std::array{0, 1, 2};
        patch.normal = {0.6, 0.8, 0.0};
      }
      const ContactTraction t =
          tractionFromNodes(chain.patches, test::randomNodes(chain.numNodes(), random), 2, degree);
      const Vector first = contactShares(chain.patches, {t, t}, 0), second = contactShares(chain.patches, {t, t}, 1);
      for (int f = 0; f < 2; ++f)
        for (const double lambda : {0.0, 0.2, 0.5}) {
          const double measure = chain.patches[std::size_t(f)].measure;
          const auto one = fromShares(first, f, degree, measure, lambda),
                     other = fromShares(second, f, degree, measure, reversed ? 1.0 - lambda : lambda);
          const double value = test::valueAt(chain.patches[std::size_t(f)], t, f, lambda);
          EXPECT_NEAR(one[0], 0.6 * value, 1e-13);
          EXPECT_NEAR(one[1], 0.8 * value, 1e-13);
          EXPECT_NEAR(other[0], -0.6 * value, 1e-13);
          EXPECT_NEAR(other[1], -0.8 * value, 1e-13);
        }
    }
}

TEST(ContactTraction, SharesBelongToTheSamePointOnBothBodies)
{
  Chain chain = test::straightChain({1.0}, 2);
  chain.patches[0].sides[1].places = {1, 0, 2};
  const ContactTraction t = tractionFromNodes(chain.patches, {-1.0, 0.0, 0.0}, 2, 2);
  const Vector first = contactShares(chain.patches, {t, t}, 0), second = contactShares(chain.patches, {t, t}, 1);
  const auto resultant = [](const Vector& shares, std::size_t a) { return shares[a * 6 + 1]; };
  EXPECT_NEAR(resultant(first, 0), -resultant(second, 1), 1e-15);
  EXPECT_NEAR(resultant(first, 1), -resultant(second, 0), 1e-15);
}

TEST(ContactTraction, ABodyTakesTheFacetsItTouchesWithTheTractionOfItsRole)
{
  Chain chain = test::straightChain({1.0, 1.0, 1.0}, 1);
  chain.patches[1].sides[1].body = 2;
  chain.patches[2].sides[0].body = 1, chain.patches[2].sides[1].body = 2;
  const ContactTraction above = tractionFromNodes(chain.patches, Vector(4, -1.0), 1, 1),
                        below = tractionFromNodes(chain.patches, Vector(4, -2.0), 1, 1);
  const auto forces = [&](int body) {
    const Vector shares = contactShares(chain.patches, {above, below}, body);
    Vector perFacet;
    for (std::size_t f = 0; f * 8 < shares.size(); ++f)
      perFacet.push_back(shares[f * 8 + 1] + shares[f * 8 + 5]);
    return perFacet;
  };
  const auto expectForces = [](const Vector& found, const Vector& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-15);
  };
  expectForces(forces(0), {1.0, 1.0});
  expectForces(forces(1), {-2.0, 1.0});
  expectForces(forces(2), {-2.0, -2.0});
}

TEST(ContactTraction, RefusesADegreeBelowTheOrder)
{
  const Chain chain = test::straightChain({1.0}, 2);
  EXPECT_THROW(tractionFromNodes(chain.patches, Vector(3, -1.0), 2, 1), InternalError);
}

} // namespace ndframe
