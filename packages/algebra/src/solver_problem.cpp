#include "ndframe/algebra/solver_problem.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/algebra/pivot_rows.hpp"
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
  NDFRAME_ASSERT(K.rowPtr.size() == std::size_t(K.numRows()) + 1, "rowPtr does not fit the rows");
  NDFRAME_ASSERT(problem.nearNullSpace.cols() == 0 || problem.nearNullSpace.rows() == K.numDofs(),
                 "the near null space needs one row per dof");
  const auto numKept = std::count(problem.roles.begin(), problem.roles.end(), DofRole::Kept);
  NDFRAME_ASSERT(numKept == std::ptrdiff_t(problem.kept.size()), "kept dofs and roles disagree");
  for (const int dof : problem.kept)
    NDFRAME_ASSERT(problem.roles[std::size_t(dof)] == DofRole::Kept, "kept dofs and roles disagree");
}

/// The modes, each scaled to a largest entry of one (a rotation carries the unit of length).
class UnitModes
{
public:
  /// modes: must outlive it.
  explicit UnitModes(const DenseMatrix& modes) : modes_(modes)
  {
    for (int m = 0; m < modes.cols(); ++m) {
      largest_.push_back(largestEntry(modes.column(m)));
      NDFRAME_ASSERT(largest_.back() > 0.0, "a mode of the near null space is zero");
    }
  }

  DenseMatrix rows(const std::vector<int>& dofs) const
  {
    DenseMatrix rows(int(dofs.size()), modes_.cols());
    for (int m = 0; m < modes_.cols(); ++m)
      for (int i = 0; i < rows.rows(); ++i)
        rows(i, m) = modes_(dofs[std::size_t(i)], m) / largest_[std::size_t(m)];
    return rows;
  }

  Vector combined(Vector amplitudes) const
  {
    for (std::size_t m = 0; m < amplitudes.size(); ++m)
      amplitudes[m] /= largest_[m];
    return multiply(modes_, amplitudes);
  }

private:
  const DenseMatrix& modes_;
  Vector largest_;
};

std::vector<int> dofsOf(const SolverProblem& problem, std::initializer_list<DofRole> roles)
{
  std::vector<int> dofs;
  for (std::size_t dof = 0; dof < problem.roles.size(); ++dof)
    if (std::find(roles.begin(), roles.end(), problem.roles[dof]) != roles.end())
      dofs.push_back(int(dof));
  return dofs;
}

/// Whether a motion needs no energy.
class EnergyTest
{
public:
  EnergyTest(const SolverProblem& problem, const Comm& comm)
      : K_(*problem.matrix), comm_(comm), stiffness_(largestEntry(diagonal(K_, comm)))
  {}
  bool isFree(const Vector& motion) const
  {
    return largestEntry(multiply(K_, motion, comm_)) <= zeroMotion * stiffness_ * largestEntry(motion);
  }

private:
  const BlockMatrix& K_;
  const Comm& comm_;
  double stiffness_;
};

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
  const UnitModes modes(problem.nearNullSpace);
  const DenseMatrix unheld = nullSpace(modes.rows(dofsOf(problem, {DofRole::Fixed, DofRole::Kept})), zeroMotion);
  const EnergyTest energy(problem, comm);
  for (int k = 0; k < unheld.cols(); ++k) {
    const Vector motion = modes.combined(unheld.column(k));
    if (!energy.isFree(motion))
      continue;
    const auto most =
        std::max_element(motion.begin(), motion.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const int dof = int(most - motion.begin());
    throw SingularBody(
        fmt::format("a rigid motion of the body moves none of its fixed or interface dofs; dof {} moves most", dof),
        dof);
  }
}

FreeMotions freeMotions(const SolverProblem& problem, const Comm& comm)
{
  FreeMotions motions{DenseMatrix(int(problem.kept.size()), 0), {}};
  if (problem.nearNullSpace.cols() == 0 || problem.kept.empty())
    return motions;
  const UnitModes modes(problem.nearNullSpace);
  const DenseMatrix unheld = nullSpace(modes.rows(dofsOf(problem, {DofRole::Fixed})), zeroMotion);
  const EnergyTest energy(problem, comm);
  for (int k = 0; k < unheld.cols(); ++k)
    if (!energy.isFree(modes.combined(unheld.column(k))))
      return motions; // these modes do not know what the body can do
  motions.traces = multiply(modes.rows(problem.kept), unheld);
  motions.held = pivotRows(motions.traces);
  return motions;
}

} // namespace ndframe
