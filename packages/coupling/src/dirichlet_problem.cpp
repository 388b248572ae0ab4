#include "dirichlet_problem.hpp"

#include <algorithm>

#include "ndframe/interface/congruence.hpp"

namespace ndframe
{
namespace
{

/// What contact alone stops, in (x, alpha): motions of the Dirichlet bodies (x = R1) and of the Neumann bodies
/// (alpha = 1, u1 at rest: x = - R).
DenseMatrix motionsOf(const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  const int n = dirichlet.freeMotions.rows(), own = dirichlet.freeMotions.cols(), others = neumann.freeMotions.cols();
  DenseMatrix motions(n + others, own + others);
  for (int j = 0; j < own; ++j)
    std::copy_n(dirichlet.freeMotions.col(j), n, motions.col(j));
  for (int m = 0; m < others; ++m) {
    for (int i = 0; i < n; ++i)
      motions(i, own + m) = -neumann.freeMotions(i, m);
    motions(n + m, own + m) = 1.0;
  }
  return motions;
}

std::vector<std::string> namesOf(const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  auto names = dirichlet.motionNames;
  names.insert(names.end(), neumann.motionNames.begin(), neumann.motionNames.end());
  return names;
}

/// The displacements x are bounded, the amplitudes are not.
std::vector<char> boundedEntries(const DenseMatrix& R)
{
  std::vector<char> constrained(std::size_t(R.rows() + R.cols()), 0);
  std::fill_n(constrained.begin(), R.rows(), char(1));
  return constrained;
}

/// (g1, R^T (g1 + g2)).
Vector extendedLoad(const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  Vector both = dirichlet.g, load = dirichlet.g;
  for (std::size_t i = 0; i < both.size(); ++i)
    both[i] += neumann.g[i];
  const Vector work = multiplyTransposed(neumann.freeMotions, both);
  load.insert(load.end(), work.begin(), work.end());
  return load;
}

/// S in u = x + R alpha.
std::shared_ptr<const SymmetricOperator> extended(std::shared_ptr<const SymmetricOperator> S, const DenseMatrix& R)
{
  std::vector<SparseRow> P;
  for (int i = 0; i < R.rows(); ++i) {
    P.push_back({{i, 1.0}});
    for (int m = 0; m < R.cols(); ++m)
      if (R(i, m) != 0.0)
        P.back().emplace_back(R.rows() + m, R(i, m));
  }
  return congruence({{std::move(S), std::move(P)}}, R.rows() + R.cols(), R.cols());
}

} // namespace

DirichletProblem::DirichletProblem(const RoleSystem& dirichlet, const RoleSystem& neumann, Ledger& ledger)
    : R_(neumann.freeMotions), S_(extended(dirichlet.S, R_)), b_(extendedLoad(dirichlet, neumann)),
      problem_(*S_, boundedEntries(R_), motionsOf(dirichlet, neumann), namesOf(dirichlet, neumann), ledger)
{}

DirichletStep DirichletProblem::solve(UnknownValues u2, const UnknownValues& gap, const std::vector<char>& closed)
{
  const std::size_t n = gap.size(), all = b_.size();
  Vector bound = u2;
  for (std::size_t i = 0; i < n; ++i)
    bound[i] += gap[i];
  bound.resize(all, 0.0);
  std::vector<char> start = closed;
  start.resize(all, 0);
  DirichletStep step{problem_.solve(b_, bound, std::move(start)), std::move(u2), {}};
  step.motions.assign(step.status.u.begin() + std::ptrdiff_t(n), step.status.u.end());
  const Vector rigid = multiply(R_, step.motions);
  for (std::size_t i = 0; i < n; ++i) {
    step.status.u[i] += rigid[i];
    step.uNeumann[i] += rigid[i];
  }
  step.status.u.resize(n);
  step.status.force.resize(n);
  step.status.closed.resize(n);
  return step;
}

} // namespace ndframe
