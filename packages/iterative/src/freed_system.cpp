#include "freed_system.hpp"

#include "own_dofs.hpp"

namespace ndframe
{

NodalField FreedSystem::solve(const NodalField& load, const NodalField& start, Exactness exactness) const
{
  if (!problem_.isHeld)
    throw SingularBody("no interface dofs hold the body", -1);
  Vector carried(load.begin(), load.end());
  for (std::size_t dof = 0; dof < carried.size(); ++dof)
    if (problem_.roles[dof] == DofRole::Fixed)
      carried[dof] = 0.0;
  const double size = normOf(carried, comm_);
  const Vector first(start.begin(), start.end());
  try {
    return {start.map(), start.width(), system().solve(carried, first, size, exactness)};
  } catch (const SingularBody&) {
    if (largestEigenvalue_ == 0.0)
      throw;
  }
  system_.reset(); // the eigenvalue of others was too small
  largestEigenvalue_ = 0.0;
  return {start.map(), start.width(), system().solve(carried, first, size, exactness)};
}

void FreedSystem::forgetSolutions() const
{
  if (system_)
    system_->forgetSolutions();
}

const KrylovSystem& FreedSystem::system() const
{
  if (!system_) {
    RankProblem held = problem_;
    for (const int k : problem_.holding)
      if (const int dof = held.held(held.kept[std::size_t(k)]); dof >= 0)
        held.roles[std::size_t(dof)] = DofRole::Fixed;
    held.largestEigenvalue = largestEigenvalue_;
    system_ = std::make_unique<KrylovSystem>(held, comm_, ledger_, options_, makeCg_, hasTwoLevels_);
  }
  return *system_;
}

} // namespace ndframe
