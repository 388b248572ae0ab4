#include "solver_problem.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

/// Motions this much smaller than the body's largest are none, relative to unit modes.
constexpr double zeroMotion = 1e-9;

void checkShapes(const SolverProblem& problem)
{
  NDFRAME_ASSERT(problem.matrix != nullptr, "a solver needs a matrix");
  const BlockMatrix& K = *problem.matrix;
  NDFRAME_ASSERT(int(problem.roles.size()) == K.numDofs(), "one role per dof is needed");
  NDFRAME_ASSERT(K.rowPtr.size() == K.rows.size() + 1, "rowPtr does not fit the rows");
  NDFRAME_ASSERT(problem.nearNullSpace.cols() == 0 || problem.nearNullSpace.rows() == K.numDofs(),
                 "the near null space needs one row per dof");
  const auto numKept = std::count(problem.roles.begin(), problem.roles.end(), DofRole::Kept);
  NDFRAME_ASSERT(numKept == std::ptrdiff_t(problem.kept.size()), "kept dofs and roles disagree");
  for (const int dof : problem.kept)
    NDFRAME_ASSERT(problem.roles[std::size_t(dof)] == DofRole::Kept, "kept dofs and roles disagree");
}

/// The modes, each scaled to a largest entry of one (a rotation carries the unit of length).
DenseMatrix unitModes(DenseMatrix modes)
{
  for (int m = 0; m < modes.cols(); ++m) {
    const double largest = largestEntry(modes.column(m));
    NDFRAME_ASSERT(largest > 0.0, "a mode of the near null space is zero");
    for (int i = 0; i < modes.rows(); ++i)
      modes(i, m) /= largest;
  }
  return modes;
}

DenseMatrix rowsNotInterior(const DenseMatrix& modes, const std::vector<DofRole>& roles)
{
  std::vector<int> held;
  for (std::size_t dof = 0; dof < roles.size(); ++dof)
    if (roles[dof] != DofRole::Interior)
      held.push_back(int(dof));
  DenseMatrix rows(int(held.size()), modes.cols());
  for (int m = 0; m < modes.cols(); ++m)
    for (int i = 0; i < rows.rows(); ++i)
      rows(i, m) = modes(held[std::size_t(i)], m);
  return rows;
}

} // namespace

FreeDofs::FreeDofs(const std::vector<DofRole>& roles) : number(roles.size(), -1)
{
  for (std::size_t dof = 0; dof < roles.size(); ++dof) {
    if (roles[dof] == DofRole::Fixed)
      continue;
    number[dof] = int(dofs.size());
    dofs.push_back(int(dof));
  }
}

void checkProblem(const SolverProblem& problem, const Comm& comm)
{
  checkShapes(problem);
  if (std::count(problem.roles.begin(), problem.roles.end(), DofRole::Fixed) == std::ptrdiff_t(problem.roles.size()))
    throw InputError("Every displacement of a body is prescribed; nothing is left to solve for.");
  if (problem.nearNullSpace.cols() == 0)
    return;
  const DenseMatrix modes = unitModes(problem.nearNullSpace);
  const DenseMatrix unheld = nullSpace(rowsNotInterior(modes, problem.roles), zeroMotion);
  const double stiffness = largestEntry(diagonal(*problem.matrix, comm));
  for (int k = 0; k < unheld.cols(); ++k) {
    const Vector motion = multiply(modes, unheld.column(k));
    const double force = largestEntry(multiply(*problem.matrix, motion, comm));
    if (force > zeroMotion * stiffness * largestEntry(motion))
      continue;
    const auto most =
        std::max_element(motion.begin(), motion.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const int dof = int(most - motion.begin());
    throw SingularBody(
        fmt::format("a rigid motion of the body moves none of its fixed or interface dofs; dof {} moves most", dof),
        dof);
  }
}

} // namespace ndframe
