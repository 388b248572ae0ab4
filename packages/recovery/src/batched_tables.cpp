#include "batched_tables.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/recovery/static_data.hpp"
#include "star_wrench.hpp"
#include "sub_cell.hpp"

namespace ndframe
{
namespace
{

/// Exact for the products of two bases on the split triangle; barycentric coordinates in the triangle.
QuadratureRule splitRule(int degree)
{
  const QuadratureRule rule = simplexRule(2, degree);
  QuadratureRule split;
  split.dim = 2;
  double lambda[3];
  for (int sub = 0; sub < 3; ++sub)
    for (int point = 0; point < rule.size(); ++point) {
      SubCell{2, sub}.simplexCoordinates(rule.point(point), lambda);
      split.lambda.insert(split.lambda.end(), lambda, lambda + 3);
      split.weights.push_back(rule.weights[std::size_t(point)] / 3.0);
    }
  return split;
}

/// Mean values of the functions of a basis times shape functions of order 2: size x nodes, row by row. `nodes` are the
/// vertices, then the middles of the edges (in 2-D: opposite to vertex 0, 1, 2).
template <int dim>
std::vector<double> meanWithShapes(const MomentBasis& basis, const QuadratureRule& rule)
{
  constexpr int nodes = Lagrange<dim, 2>::nodes;
  constexpr int place[6] = {0, 1, 2, dim == 1 ? 2 : 5, 3, 4}; // edges 01, 12, 20
  std::vector<double> means(std::size_t(basis.size() * nodes), 0.0), m(std::size_t(basis.size()), 0.0);
  double N[nodes];
  for (int point = 0; point < rule.size(); ++point) {
    basis.values(rule.point(point), m.data());
    Lagrange<dim, 2>::values(rule.point(point), N);
    for (int k = 0; k < basis.size(); ++k)
      for (int a = 0; a < nodes; ++a)
        means[std::size_t(k * nodes + place[a])] += rule.weights[std::size_t(point)] * m[std::size_t(k)] * N[a];
  }
  return means;
}

} // namespace

std::array<double, 6> planeStiffness(const Elasticity& law)
{
  return {law(0, 0), law(0, 1), law(0, 2), law(1, 1), law(1, 2), law(2, 2)};
}

std::array<double, 6> planeCompliance(const Elasticity& law)
{
  CellMap unit;
  unit.dim = 2;
  unit.F = {1.0, 0.0, 0.0, 1.0};
  unit.det = 1.0;
  const std::vector<double> entries = pulledBackCompliance(unit, law);
  std::array<double, 6> C;
  std::copy(entries.begin(), entries.end(), C.begin());
  return C;
}

BatchedCellTables::BatchedCellTables(int degree, const Elasticity& law)
    : facetWork_(meanWithShapes<1>(facetBasis(2, degree), simplexRule(1, degree + 2))),
      loadWork_(meanWithShapes<2>(loadBasis(2, degree), splitRule(degree + 2)))
{
  const ReferenceStress& reference = referenceStress(2, degree);
  const int modes = reference.coefficients / 9;
  const double scale = std::sqrt(1.0 / 6.0); // of the sub-cells' measure: squares become integrals
  const auto append = [&](std::vector<double>& table, const DenseMatrix& from) {
    for (int sub = 0; sub < 3; ++sub)
      for (int mode = 0; mode < modes; ++mode)
        for (int j = 0; j < from.cols(); ++j)
          for (int a = 0; a < 3; ++a)
            table.push_back(scale * from((sub * 3 + a) * modes + mode, j));
  };
  append(lift_, reference.lift);
  append(bubble_, reference.bubble);
  const int data = reference.data();
  for (int b = 0; b < reference.bubbles; ++b)
    for (int j = b; j < reference.bubbles; ++j)
      for (const DenseMatrix& energy : reference.energy)
        bubbleForm_.push_back(energy(data + b, data + j));
  tables_ = {lift_.data(), bubble_.data(), bubbleForm_.data(), facetWork_.data(), loadWork_.data(), {}, {}};
  std::copy_n(planeCompliance(law).begin(), 6, tables_.compliance);
  std::copy_n(planeStiffness(law).begin(), 6, tables_.stiffness);
}

LoadPermutations::LoadPermutations(int degree)
{
  const MomentBasis basis = loadBasis(2, degree);
  const QuadratureRule rule = splitRule(2 * degree);
  const int n = basis.size();
  std::vector<double> ours(std::size_t(n), 0.0), ascending(std::size_t(n), 0.0);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      if (a == b)
        continue;
      std::vector<double>& matrix = matrices_[std::size_t(3 * a + b)];
      matrix.assign(std::size_t(n * n), 0.0);
      for (int point = 0; point < rule.size(); ++point) {
        const double* lambda = rule.point(point);
        const double turned[3] = {lambda[a], lambda[b], lambda[3 - a - b]};
        basis.values(turned, ours.data());
        basis.values(lambda, ascending.data());
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            matrix[std::size_t(i * n + j)] +=
                rule.weights[std::size_t(point)] * ours[std::size_t(i)] * ascending[std::size_t(j)];
      }
    }
}

} // namespace ndframe
