#pragma once

#include <array>
#include <vector>

#include "batched_kernels.hpp"
#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/mechanics/cell_laws.hpp"

namespace ndframe
{

/// What LoadModes points to.
struct LoadArrays
{
  std::vector<double> coupling, force, arms, bend, share;
  LoadModes modes() const;
};

PlaneLaw planeLaw(const Elasticity& law);

/// Per law of a body; none when it has only one, which the tables know.
std::vector<PlaneLaw> severalLaws(const CellLaws& laws);

/// The tables of StarTables for stresses of degree q, displacements of order p and a material, derived from
/// referenceStress(2, q).
class BatchedStarTables
{
public:
  BatchedStarTables(int degree, int order, const Elasticity& law);
  BatchedStarTables(const BatchedStarTables&) = delete;
  BatchedStarTables& operator=(const BatchedStarTables&) = delete;

  const StarTables& tables() const { return tables_; }

private:
  std::vector<double> form_;
  LoadArrays constant_, full_, withRim_;
  StarTables tables_{};
};

/// The tables of CellTables.
class BatchedCellTables
{
public:
  BatchedCellTables(int degree, const Elasticity& law);
  BatchedCellTables(const BatchedCellTables&) = delete;
  BatchedCellTables& operator=(const BatchedCellTables&) = delete;

  const CellTables& tables() const { return tables_; }

private:
  std::vector<double> lift_, bubble_, bubbleForm_, linear_;
  CellTables tables_{};
};

/// The load basis of a cell under a renumbering of its vertices: moments with vertices in the order a, b, c from those
/// with vertices ascending. rank[i]: place of the i-th vertex among the ascending ones.
class LoadPermutations
{
public:
  explicit LoadPermutations(int degree);
  /// modes x modes, row by row.
  const double* of(int rankA, int rankB) const { return matrices_[3 * std::size_t(rankA) + std::size_t(rankB)].data(); }

private:
  std::array<std::vector<double>, 9> matrices_;
};

} // namespace ndframe
