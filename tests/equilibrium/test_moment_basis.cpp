#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "equilibrium/sample_stress.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{
namespace
{

std::vector<MomentBasis> allBases()
{
  std::vector<MomentBasis> bases;
  for (int dim = 1; dim <= 3; ++dim)
    for (int degree = 0; degree <= 3; ++degree)
      bases.push_back(MomentBasis::polynomials(dim, degree));
  for (int dim = 2; dim <= 3; ++dim)
    bases.push_back(MomentBasis::piecewiseConstant(dim));
  return bases;
}

std::vector<double> valuesAt(const MomentBasis& basis, const double* lambda)
{
  std::vector<double> m(std::size_t(basis.size()));
  basis.values(lambda, m.data());
  return m;
}

std::vector<double> insidePoint(int dim, unsigned seed)
{
  std::vector<double> lambda;
  double sum = 0.0;
  test::Random random(seed);
  for (int a = 0; a <= dim; ++a)
    sum += lambda.emplace_back(random(0.1, 1.0));
  for (double& value : lambda)
    value /= sum;
  return lambda;
}

} // namespace

TEST(MomentBasis, IsOrthonormalForTheMeanValueAndStartsWithOne)
{
  for (const MomentBasis& basis : allBases()) {
    DenseMatrix mean(basis.size(), basis.size());
    test::overSubCells(basis.dim(), 6, [&](int, const double* lambda, double weight) {
      const auto m = valuesAt(basis, lambda);
      EXPECT_NEAR(m[0], 1.0, 1e-15);
      for (int k = 0; k < basis.size(); ++k)
        for (int l = 0; l < basis.size(); ++l)
          mean(k, l) += weight * m[std::size_t(k)] * m[std::size_t(l)];
    });
    for (int k = 0; k < basis.size(); ++k)
      for (int l = 0; l < basis.size(); ++l)
        EXPECT_NEAR(mean(k, l), k == l ? 1.0 : 0.0, 2e-14) << "dim " << basis.dim() << ": " << k << ", " << l;
  }
}

TEST(MomentBasis, HasTheSizeOfItsSpace)
{
  EXPECT_EQ(facetBasis(2, 3).size(), 4);
  EXPECT_EQ(facetBasis(3, 1).size(), 3);
  EXPECT_EQ(facetBasis(3, 2).size(), 6);
  EXPECT_EQ(loadBasis(2, 1).size(), 3);
  EXPECT_EQ(loadBasis(2, 2).size(), 3);
  EXPECT_EQ(loadBasis(2, 3).size(), 6);
  EXPECT_EQ(loadBasis(3, 1).size(), 4);
  EXPECT_EQ(MomentBasis::polynomials(3, 3).size(), 20);
}

TEST(MomentBasis, OnEdgesIsLegendres)
{
  const MomentBasis basis = facetBasis(2, 2);
  for (const double x : {0.0, 0.3, 1.0}) {
    const double lambda[] = {1.0 - x, x}, s = 2.0 * x - 1.0;
    const auto m = valuesAt(basis, lambda);
    EXPECT_NEAR(m[1], std::sqrt(3.0) * s, 1e-14);
    EXPECT_NEAR(m[2], std::sqrt(5.0) * (1.5 * s * s - 0.5), 1e-14);
  }
}

TEST(MomentBasis, OfALowerDegreeIsTheBeginning)
{
  for (int dim = 1; dim <= 3; ++dim) {
    const auto lambda = insidePoint(dim, 3);
    const auto low = valuesAt(MomentBasis::polynomials(dim, 1), lambda.data()),
               high = valuesAt(MomentBasis::polynomials(dim, 3), lambda.data());
    for (std::size_t k = 0; k < low.size(); ++k)
      EXPECT_NEAR(low[k], high[k], 1e-14);
  }
}

TEST(MomentBasis, GradientsAreTheDifferencesOfCubics)
{
  const double step = 0.01;
  for (int dim = 1; dim <= 3; ++dim) {
    const MomentBasis basis = MomentBasis::polynomials(dim, 3);
    const auto at = insidePoint(dim, 8);
    std::vector<double> gradients(std::size_t(basis.size() * dim));
    basis.gradients(at.data(), gradients.data());
    for (int d = 0; d < dim; ++d) {
      const auto moved = [&](double amount) {
        auto lambda = at;
        lambda[0] -= amount;
        lambda[std::size_t(d + 1)] += amount;
        return valuesAt(basis, lambda.data());
      };
      const auto right = moved(step), left = moved(-step), farRight = moved(2.0 * step), farLeft = moved(-2.0 * step);
      for (std::size_t k = 0; k < right.size(); ++k)
        EXPECT_NEAR(gradients[k * std::size_t(dim) + std::size_t(d)],
                    (8.0 * (right[k] - left[k]) - (farRight[k] - farLeft[k])) / (12.0 * step), 1e-11);
    }
  }
}

TEST(MomentBasis, OfSubCellsIsConstantThere)
{
  for (int dim = 2; dim <= 3; ++dim) {
    const MomentBasis basis = MomentBasis::piecewiseConstant(dim);
    std::set<std::vector<double>> values;
    test::overSubCells(dim, 4, [&](int, const double* lambda, double) { values.insert(valuesAt(basis, lambda)); });
    EXPECT_EQ(values.size(), std::size_t(dim + 1));
    std::vector<double> gradients(std::size_t(basis.size() * dim), 1.0);
    basis.gradients(insidePoint(dim, 5).data(), gradients.data());
    EXPECT_EQ(gradients, std::vector<double>(gradients.size(), 0.0));
  }
}

TEST(MomentBasis, VertexForceTakesTheValueOfAffineFunctionsAtTheVertex)
{
  for (const MomentBasis& basis : allBases()) {
    if (basis.size() <= basis.dim())
      continue;
    const std::size_t vertices = std::size_t(basis.dim() + 1);
    std::vector<double> force(std::size_t(basis.size()));
    for (std::size_t a = 0; a < vertices; ++a) {
      basis.vertexForce(int(a), force.data());
      std::vector<double> work(vertices, 0.0);
      test::overSubCells(basis.dim(), 4, [&](int, const double* lambda, double weight) {
        const auto m = valuesAt(basis, lambda);
        for (std::size_t k = 0; k < m.size(); ++k)
          for (std::size_t b = 0; b < vertices; ++b)
            work[b] += weight * force[k] * m[k] * lambda[b];
      });
      for (std::size_t b = 0; b < vertices; ++b)
        EXPECT_NEAR(work[b], a == b ? 1.0 : 0.0, 1e-13);
    }
  }
}

TEST(MomentBasis, RefusesWhatItIsNotMadeFor)
{
  EXPECT_THROW(MomentBasis::polynomials(4, 1), InternalError);
  EXPECT_THROW(MomentBasis::piecewiseConstant(1), InternalError);
  std::vector<double> force(1);
  EXPECT_THROW(MomentBasis::polynomials(2, 0).vertexForce(0, force.data()), InternalError);
}

TEST(SortedCell, HasItsVerticesAscendingAndKnowsWhereTheyStood)
{
  const Mesh mesh = test::renumbered(test::box({2, 2, 1}), 4);
  for (int c = 0; c < mesh.numCells(); ++c) {
    const SortedCell cell = sortedCell(mesh, c);
    EXPECT_TRUE(std::is_sorted(cell.vertices.begin(), cell.vertices.end()));
    for (std::size_t a = 0; a < 4; ++a) {
      EXPECT_EQ(mesh.cell(c)[cell.local[a]], cell.vertices[a]);
      EXPECT_EQ(sortedFacet(mesh, {c, cell.local[a]}), int(a));
    }
  }
}

} // namespace ndframe
