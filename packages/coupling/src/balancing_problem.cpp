#include "balancing_problem.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr int mostIterations = 2000;  ///< a pass
constexpr double amplification = 1e2; ///< of the tolerance: what single forces may be wrong by, relative to the largest

void add(Vector& a, double factor, const Vector& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
}

} // namespace

BalancingProblem::BalancingProblem(const Network& network, double tolerance, Ledger& ledger)
    : network_(network), tolerance_(tolerance), ledger_(ledger), motions_(motionNames(network)), bodies_(network),
      v_(std::size_t(network.size()), 0.0)
{}

bool BalancingProblem::holds(const std::vector<char>& closed)
{
  if (!set_ || !set_->isOf(closed))
    set_ = std::make_unique<BalancingSet>(network_, bodies_, closed);
  return set_->holds();
}

/// y with A y = residual.
Vector BalancingProblem::solveSet(Vector residual)
{
  const Vector load = residual;
  Vector y = set_->balanced(residual);
  add(residual, -1.0, set_->product(y));
  Vector z = set_->preconditioned(residual), p = z;
  double square = dot(residual, z);
  for (int iteration = 0; iteration < mostIterations; ++iteration) {
    const double size = std::abs(dot(load, y)) + square;
    if (square <= std::pow(tolerance_, 2) * size)
      break;
    ledger_.count("Neumann-Neumann iterations");
    ledger_.tell(Depth::Iteration, Progress::falling("iteration", iteration + 1, "error", std::sqrt(square),
                                                     tolerance_ * std::sqrt(size)));
    const Vector Ap = set_->product(p);
    const double step = square / dot(p, Ap);
    add(y, step, p);
    add(residual, -step, Ap);
    z = set_->preconditioned(residual);
    const double last = std::exchange(square, dot(residual, z));
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = z[i] + square / last * p[i];
  }
  return y;
}

void BalancingProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  NDFRAME_ASSERT(proximal == 0.0, "sets that leave bodies free are solved by forces");
  if (!holds(closed))
    throw NotPositiveDefinite(-1);
  bodies_.factor(0.0);
  const ClosedRows& rows = set_->rows();
  const Vector start = rows.expanded(Vector(std::size_t(rows.numFree()), 0.0));
  v_ = rows.expanded(solveSet(rows.reduced(bodies_.unbalanced(start, 0.0, start))));
  Vector rest = bodies_.unbalanced(v_, 0.0, v_);
  pass.unbalanced = largestEntry(rows.reduced(rest));
  for (double& value : rest)
    value = -value;
  pass.force = rows.forces(rest);
  setDisplacement(network_, v_, pass);
  pass.roundOff = std::max(statusRoundOff, amplification * tolerance_);
}

} // namespace ndframe
