#include "krylov_system.hpp"

#include <algorithm>
#include <mutex>

#include "ndframe/algebra/ghosts.hpp"
#include "own_dofs.hpp"
#include "restarted_gradients.hpp"

namespace ndframe
{

namespace
{

/// Bodies may be solved by several threads; the libraries are for one at a time.
std::mutex& librariesInUse()
{
  static std::mutex mutex;
  return mutex;
}

} // namespace

KrylovSystem::KrylovSystem(const RankProblem& problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
                           const MakeConjugateGradients& makeCg, bool hasTwoLevels)
    : matrix_(*problem.matrix), comm_(comm), ledger_(ledger), options_(options), recycled_(comm)
{
  const std::lock_guard lock(librariesInUse());
  startMpi();
  for (int r = 0; r < matrix_.numRows(); ++r)
    for (int i = 0; i < matrix_.dim; ++i)
      isInterior_.push_back(problem.role(r, i) == DofRole::Interior);
  ghosts_ = sharedGhosts(matrix_.nodes, comm);
  cg_ = makeCg(problem, comm, meanDiagonal(matrix_, comm));
  if (hasTwoLevels)
    ledger_.count("multigrid set-ups");
  work_.enter(work(), comm_, ledger_);
}

Vector KrylovSystem::solve(const Vector& load, const Vector& start, double reference, Exactness exactness) const
{
  const std::lock_guard lock(librariesInUse());
  Vector u = start;
  u.resize(std::size_t(matrix_.nodes.size()) * std::size_t(matrix_.dim));
  fetchGhosts(u);
  Vector residual = interiorResidual(load, u);
  const double initial = std::max(normOf(residual, comm_), reference);
  add(recycled_.start(residual), u);
  const auto ownDofs = std::ptrdiff_t(load.size());
  const Vector first(u.begin(), u.begin() + ownDofs), missing = residual = interiorResidual(load, u);
  const int iterations = restartedGradients(
      toleranceFor(exactness, options_.tolerance) * initial, initial, options_.maxIterations, normOf(residual, comm_),
      ledger_,
      [&](double reduction, int most, const auto& watch) {
        ConjugateGradients::Result step = cg_->solve(residual, reduction, most, watch);
        for (std::size_t dof = 0; dof < step.x.size(); ++dof)
          if (!isInterior_[dof]) // multigrid leaves round-off in the decoupled rows
            step.x[dof] = 0.0;
        add(step.x, u);
        return step.iterations;
      },
      [&] {
        residual = interiorResidual(load, u);
        return normOf(residual, comm_);
      },
      [&] { return rowRoundOff * normOf(ownSizes(matrix_, u), comm_); });
  if (iterations > 0)
    recycled_.add(difference({u.begin(), u.begin() + ownDofs}, first), difference(missing, residual));
  ledger_.count("back-solves");
  ledger_.count("Krylov solves");
  ledger_.count("Krylov iterations", iterations);
  work_.enter(work(), comm_, ledger_);
  u.resize(load.size());
  return u;
}

/// held += own, and the ghosts are those of their owners again.
void KrylovSystem::add(const Vector& own, Vector& held) const
{
  for (std::size_t dof = 0; dof < own.size(); ++dof)
    held[dof] += own[dof];
  fetchGhosts(held);
}

void KrylovSystem::fetchGhosts(Vector& held) const
{
  const auto dim = std::size_t(matrix_.dim);
  ghosts_.fetch([dim](int node) { return SharedValues::Place{std::size_t(node) * dim, dim}; }, held);
}

/// load - K u on own interior dofs, zero elsewhere.
Vector KrylovSystem::interiorResidual(const Vector& load, const Vector& held) const
{
  Vector residual = ownProduct(matrix_, held);
  work_.addResidual();
  for (std::size_t dof = 0; dof < residual.size(); ++dof)
    residual[dof] = isInterior_[dof] ? load[dof] - residual[dof] : 0.0;
  return residual;
}

/// So far, with what this rank has sent for residuals.
CycleWork KrylovSystem::work() const
{
  CycleWork work = cg_->work();
  work.traffic += {ghosts_.messages(), ghosts_.bytes()};
  return work;
}

} // namespace ndframe
