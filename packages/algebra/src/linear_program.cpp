#include "ndframe/algebra/linear_program.hpp"

#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>

namespace ndframe
{
namespace
{

constexpr double tolerance = 1e-9;
constexpr int unperturbed = 100; // Clp's number for it

Vector forClp(Vector bounds)
{
  for (double& bound : bounds)
    if (bound == unbounded || bound == -unbounded)
      bound = bound > 0.0 ? COIN_DBL_MAX : -COIN_DBL_MAX;
  return bounds;
}

CoinPackedMatrix packed(const std::vector<SparseRow>& rows, int columns)
{
  std::vector<CoinBigIndex> starts{0};
  std::vector<int> indices;
  Vector values;
  for (const auto& row : rows) {
    for (const auto& [column, value] : row) {
      indices.push_back(column);
      values.push_back(value);
    }
    starts.push_back(CoinBigIndex(indices.size()));
  }
  return {false,         columns,        int(rows.size()), CoinBigIndex(values.size()),
          values.data(), indices.data(), starts.data(),    nullptr};
}

} // namespace

std::optional<Vector> solve(const LinearProgram& program)
{
  const auto columns = int(program.cost.size());
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.setPrimalTolerance(tolerance);
  clp.setDualTolerance(tolerance);
  clp.loadProblem(packed(program.rows, columns), forClp(program.lower).data(), forClp(program.upper).data(),
                  program.cost.data(), forClp(program.rowLower).data(), forClp(program.rowUpper).data());
  clp.setOptimizationDirection(-1.0);
  ClpSolve way;
  way.setSolveType(ClpSolve::usePrimalorSprint);
  if (clp.initialSolve(way) != 0)
    return std::nullopt;
  clp.setPerturbation(unperturbed); // what is left of it, some 1e-10, goes: the vertex of the same basis
  if (clp.primal() != 0)
    return std::nullopt;
  return Vector(clp.getColSolution(), clp.getColSolution() + columns);
}

} // namespace ndframe
