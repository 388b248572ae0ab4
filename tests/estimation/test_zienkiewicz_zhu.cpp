#include "ndframe/estimation/zienkiewicz_zhu.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/smooth_scene.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{
namespace
{

using namespace test;

/// A field of degree `order` whose stress is not constant for order 2.
void polynomial(int order, int dim, const double* x, double* u)
{
  for (int k = 0; k < dim; ++k) {
    u[k] = 0.3 + 0.2 * x[k] - 0.7 * x[(k + 1) % dim];
    if (order == 2)
      u[k] += 0.4 * x[0] * x[1] + (k + 1) * x[k] * x[dim - 1];
  }
}

BodyModel randomBody(const std::vector<int>& cells, int order)
{
  return makeBody(renumbered(shaken(box(cells, "Alternating"), 0.05, 3), 4), order);
}

Vector randomField(const BodyModel& body)
{
  return Random(11).vector(std::size_t(body.numDofs()));
}

TEST(ZienkiewiczZhu, SeesNoErrorInStressesThatThePatchesReproduce)
{
  for (const int order : {1, 2})
    for (const std::vector<int>& cells : {std::vector<int>{4, 3}, std::vector<int>{2, 2, 2}}) {
      const BodyModel body = randomBody(cells, order);
      const Vector u =
          interpolate(body.nodes, [&](const double* x, double* v) { polynomial(order, body.mesh.dim, x, v); });
      EXPECT_LT(sum(zienkiewiczZhu(body, u)), 1e-20 * sum(cellEnergies(body, u))) << order << ' ' << cells.size();
    }
}

TEST(ZienkiewiczZhu, CopesWithMeshesTooSmallForItsPolynomials)
{
  for (const int order : {1, 2}) {
    const BodyModel body = randomBody({1, 1}, order);
    const Vector u = randomField(body);
    const double estimate = sum(zienkiewiczZhu(body, u));
    EXPECT_GT(estimate, 0.0);
    EXPECT_LT(estimate, 2.0 * sum(cellEnergies(body, u)));
  }
}

/// However stretched they are, and along whatever axis: patches that grew through such meshes took minutes.
TEST(ZienkiewiczZhu, LooksNoFurtherThanAFewCells)
{
  for (const int order : {1, 2})
    for (const double height : {1.0, 300.0, 1e5}) {
      const BodyModel body = makeBody(moved(box({40, 2}, "Alternating"),
                                            [&](double* x) {
                                              const double y = height * x[1];
                                              x[1] = 0.5 * x[0] + 0.8 * y;
                                              x[0] = 0.8 * x[0] - 0.5 * y;
                                            }),
                                      order);
      Vector u = randomField(body);
      const Vector before = zienkiewiczZhu(body, u);
      int changed = 0;
      u.front() += 1.0; // at the first corner
      const Vector after = zienkiewiczZhu(body, u);
      for (std::size_t c = 0; c < before.size(); ++c)
        changed += after[c] != before[c];
      EXPECT_GT(changed, 0);
      EXPECT_LT(changed, 40) << "order " << order << ", height " << height << ", of " << before.size();
    }
}

/// sigma* tends to sigma faster than sigma_h: the estimate over the error tends to one.
TEST(ZienkiewiczZhu, TendsToTheErrorOnUniformMeshes)
{
  for (const int order : {1, 2}) {
    double offBy[2];
    for (int k = 0; k < 2; ++k) {
      const BodyModel body = smoothBody((k + 1) * (order == 1 ? 8 : 4), order);
      const Vector u = solution(body);
      offBy[k] = std::abs(std::sqrt(sum(zienkiewiczZhu(body, u)) / smoothErrorSquared(body, u)) - 1.0);
    }
    EXPECT_LT(offBy[1], 0.05) << order;
    EXPECT_LT(offBy[1], 0.5 * offBy[0]) << order;
  }
}

TEST(ZienkiewiczZhu, IsAnEnergyInAllUnits)
{
  for (const int order : {1, 2})
    for (const std::vector<int>& cells : {std::vector<int>{3, 2}, std::vector<int>{2, 1, 2}}) {
      const BodyModel body = randomBody(cells, order);
      const Vector u = randomField(body), squared = zienkiewiczZhu(body, u);
      const double length = 1e3, stress = 1e9;
      BodyModel other = makeBody(moved(body.mesh,
                                       [&](double* x) {
                                         for (int k = 0; k < body.mesh.dim; ++k)
                                           x[k] *= length;
                                       }),
                                 order);
      Elasticity law = other.laws(0);
      for (double& D : law.D)
        D *= stress;
      other.laws = law;
      Vector longer = u;
      for (double& value : longer)
        value *= length;
      const Vector scaled = zienkiewiczZhu(other, longer);
      const double factor = stress * std::pow(length, body.mesh.dim);
      for (std::size_t c = 0; c < squared.size(); ++c)
        EXPECT_NEAR(scaled[c] / factor, squared[c], 1e-9 * squared[c]);
    }
}

} // namespace
} // namespace ndframe
