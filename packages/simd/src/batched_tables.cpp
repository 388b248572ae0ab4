#include "batched_tables.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"
#include "ndframe/fem/quadrature.hpp"

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

/// Of the barycentric coordinates: sub-cell by sub-cell, the first three functions of a basis, vertex by vertex. The
/// linear functions come first in a basis.
std::vector<double> linearCoefficients(const MomentBasis& basis)
{
  const QuadratureRule rule = simplexRule(2, 2);
  std::vector<double> coefficients(27, 0.0), m(std::size_t(basis.size()));
  double lambda[3];
  for (int sub = 0; sub < 3; ++sub)
    for (int point = 0; point < rule.size(); ++point) {
      basis.values(rule.point(point), m.data());
      SubCell{2, sub}.simplexCoordinates(rule.point(point), lambda);
      for (int i = 0; i < 9; ++i)
        coefficients[9 * std::size_t(sub) + std::size_t(i)] +=
            rule.weights[std::size_t(point)] * m[std::size_t(i / 3)] * lambda[i % 3];
    }
  return coefficients;
}

} // namespace

PlaneLaw planeLaw(const Elasticity& law)
{
  CellMap unit;
  unit.dim = 2;
  unit.F = {1.0, 0.0, 0.0, 1.0};
  unit.det = 1.0;
  PlaneLaw plane{{}, {law(0, 0), law(0, 1), law(0, 2), law(1, 1), law(1, 2), law(2, 2)}, {}};
  const std::vector<double> compliance = pulledBackCompliance(unit, law);
  std::copy(compliance.begin(), compliance.end(), plane.compliance);
  const DenseCholesky stiffness = stiffnessFactor(law);
  for (int j = 0; j < 3; ++j) {
    Vector column(3, 0.0);
    column[std::size_t(j)] = 1.0;
    column = stiffness.solveLower(std::move(column));
    for (int i = j; i < 3; ++i)
      plane.root[i * (i + 1) / 2 + j] = column[std::size_t(i)];
  }
  return plane;
}

std::vector<PlaneLaw> severalLaws(const CellLaws& laws)
{
  std::vector<PlaneLaw> several;
  if (!laws.isUniform())
    for (const Elasticity& law : laws.all())
      several.push_back(planeLaw(law));
  return several;
}

BatchedCellTables::BatchedCellTables(int degree, const Elasticity& law)
{
  const ReferenceStress& reference = referenceStress(2, degree);
  const int modes = reference.basis.size(), data = reference.data();
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
  for (int b = 0; b < reference.bubbles; ++b)
    for (int j = b; j < reference.bubbles; ++j)
      for (const DenseMatrix& energy : reference.energy)
        bubbleForm_.push_back(energy(data + b, data + j));
  for (const double value : linearCoefficients(reference.basis))
    linear_.push_back(scale * value);
  tables_ = {lift_.data(), bubble_.data(), bubbleForm_.data(), linear_.data(), planeLaw(law)};
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
      std::vector<double>& matrix = matrices_[3 * std::size_t(a) + std::size_t(b)];
      matrix.assign(std::size_t(n) * std::size_t(n), 0.0);
      for (int point = 0; point < rule.size(); ++point) {
        const double* lambda = rule.point(point);
        const double turned[3] = {lambda[a], lambda[b], lambda[3 - a - b]};
        basis.values(turned, ours.data());
        basis.values(lambda, ascending.data());
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            matrix[std::size_t(i) * std::size_t(n) + std::size_t(j)] +=
                rule.weights[std::size_t(point)] * ours[std::size_t(i)] * ascending[std::size_t(j)];
      }
    }
}

} // namespace ndframe
