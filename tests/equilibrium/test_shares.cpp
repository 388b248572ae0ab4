#include <gtest/gtest.h>

#include "equilibrium/sample_stress.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{
namespace
{

/// The bases on facets and cells for displacements of that order.
std::vector<MomentBasis> basesFor(int order)
{
  std::vector<MomentBasis> bases;
  for (const auto& kind : test::stressKinds())
    if (kind.degree >= order) {
      bases.push_back(facetBasis(kind.dim, kind.degree));
      bases.push_back(loadBasis(kind.dim, kind.degree));
    }
  return bases;
}

/// Mean of lambda_b times every function of the basis.
std::vector<double> momentsOfLinear(const MomentBasis& basis, int b)
{
  std::vector<double> moments(std::size_t(basis.size()), 0.0), m = moments;
  test::overSubCells(basis.dim(), 4, [&](int, const double* lambda, double weight) {
    basis.values(lambda, m.data());
    for (std::size_t k = 0; k < m.size(); ++k)
      moments[k] += weight * m[k] * lambda[b];
  });
  return moments;
}

} // namespace

TEST(Shares, OfOneSumToOne)
{
  for (int order = 1; order <= 2; ++order)
    for (const MomentBasis& basis : basesFor(order)) {
      const Shares shares(basis, order);
      for (int k = 0; k < basis.size(); ++k) {
        double sum = 0.0;
        for (int a = 0; a <= basis.dim(); ++a)
          sum += shares.ofOne(a)[k];
        EXPECT_NEAR(sum, k == 0 ? 1.0 : 0.0, 1e-14);
      }
    }
}

TEST(Shares, OfLinearFunctionsSumToTheirProjection)
{
  for (const MomentBasis& basis : basesFor(2)) {
    const Shares shares(basis, 2);
    for (int b = 0; b <= basis.dim(); ++b) {
      const auto whole = momentsOfLinear(basis, b);
      for (int k = 0; k < basis.size(); ++k) {
        double sum = 0.0, ofVertex = 0.0;
        for (int a = 0; a <= basis.dim(); ++a) {
          sum += shares.ofLinear(a, b)[k];
          ofVertex += shares.ofLinear(b, a)[k];
        }
        EXPECT_NEAR(sum, whole[std::size_t(k)], 1e-14);
        EXPECT_NEAR(ofVertex, shares.ofOne(b)[k], 1e-14); // the lambda_a add up to one
      }
    }
  }
}

TEST(Shares, OfOrderTwoAreProjectionsOfTheHatTimesTheFunction)
{
  for (const MomentBasis& basis : basesFor(2)) {
    const Shares shares(basis, 2);
    for (int a = 0; a <= basis.dim(); ++a) {
      const auto hat = momentsOfLinear(basis, a);
      for (int k = 0; k < basis.size(); ++k)
        EXPECT_NEAR(shares.ofOne(a)[k], hat[std::size_t(k)], 1e-14);
    }
  }
}

TEST(Shares, OfOrderOneActAtTheVertex)
{
  for (const MomentBasis& basis : basesFor(1)) {
    const Shares shares(basis, 1);
    for (int b = 0; b <= basis.dim(); ++b) {
      const auto affine = momentsOfLinear(basis, b);
      for (int a = 0; a <= basis.dim(); ++a) {
        double work = 0.0;
        for (int k = 0; k < basis.size(); ++k)
          work += shares.ofOne(a)[k] * affine[std::size_t(k)];
        EXPECT_NEAR(work, a == b ? 1.0 / (basis.dim() + 1) : 0.0, 1e-14);
      }
    }
  }
}

TEST(Shares, OfLinearFunctionsExistForOrderTwoOnly)
{
  EXPECT_THROW(Shares(facetBasis(2, 1), 1).ofLinear(0, 0), InternalError);
  EXPECT_THROW(Shares(facetBasis(2, 1), 3), InternalError);
}

} // namespace ndframe
