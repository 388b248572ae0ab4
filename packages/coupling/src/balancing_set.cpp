#include "balancing_set.hpp"

#include "coarse_problem.hpp"

namespace ndframe
{
BalancingSet::BalancingSet(const Network& network, const NetworkBodies& bodies, const std::vector<char>& closed)
    : network_(network), bodies_(bodies), closed_(closed),
      rows_(network.jump, tightestFirst(network, closed), network.bound, network.size())
{
  for (int entry = 0; entry < network.size(); ++entry)
    inFree_.push_back(rows_.inFree(entry));
  entries_ = transposed(inFree_, rows_.numFree());
  average_ = averagesOf(entries_, bodies.weight());
  if (bodies.numMotions() > 0)
    factorCoarse();
}

Vector BalancingSet::product(const Vector& y) const
{
  return rows_.reduced(bodies_.stiff(rows_.direction(y)));
}

/// A times a vector of few entries, in the time that these take. Both sums are zero before and after.
SparseRow BalancingSet::product(const SparseRow& column, SparseSum& entries, SparseSum& free) const
{
  for (const auto& [y, value] : column)
    entries.add(entries_[std::size_t(y)], value);
  const auto apply = [&](std::size_t body, const Vector& own) { return network_.bodies[body]->S->apply(own); };
  bodies_.bodyByBody(entries.take(), apply, [&](std::size_t entry, double force) { free.add(inFree_[entry], force); });
  return free.take();
}

/// C^T A C, whose entries are those of bodies near each other; no factor where some motion is left free.
void BalancingSet::factorCoarse()
{
  C_ = bodies_.motionColumns(transposed(average_.rows, network_.size()), rows_.numFree());
  SparseSum entries(network_.size()), free(C_.rows());
  const SymmetricEntries coarse = coarseEntries(
      C_, [&](const SparseRow& column) { return product(column, entries, free); }, AC_);
  try {
    coarse_ = std::make_unique<SparseCholesky>(coarse);
  } catch (const NotPositiveDefinite&) {
    coarse_ = nullptr;
  }
}

Vector BalancingSet::balanced(const Vector& r) const
{
  return coarse_ == nullptr ? Vector(r.size(), 0.0) : C_.times(coarse_->solve(C_.transposedTimes(r)));
}

Vector BalancingSet::preconditioned(const Vector& r) const
{
  Vector f(std::size_t(network_.size()), 0.0), z;
  for (std::size_t y = 0; y < r.size(); ++y)
    for (const auto& [entry, share] : average_.rows[y])
      f[std::size_t(entry)] += share * r[y];
  const Vector v = bodies_.flexible(f);
  for (const SparseRow& row : average_.rows) {
    z.push_back(0.0);
    for (const auto& [entry, share] : row)
      z.back() += share * v[std::size_t(entry)];
  }
  if (coarse_ == nullptr)
    return z;
  const Vector motion = C_.times(coarse_->solve(AC_.transposedTimes(z)));
  for (std::size_t y = 0; y < z.size(); ++y)
    z[y] -= motion[y];
  return z;
}

} // namespace ndframe
