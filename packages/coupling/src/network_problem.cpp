#include "network_problem.hpp"

#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

NetworkProblem::NetworkProblem(const Network& network, Ledger& ledger)
    : network_(network), ledger_(ledger), motions_(motionNames(network)), bodies_(network),
      v_(std::size_t(network.size()), 0.0)
{}

/// T^T S T of one body, T its entries of v in the free variables. local: per free variable -1, as it is left.
void NetworkProblem::addBody(std::size_t body, std::vector<int>& local, SymmetricEntries& entries) const
{
  const DenseMatrix& S = *network_.bodies[body]->S->dense();
  const int size = S.cols();
  std::vector<SparseRow> inFree;
  std::vector<int> free;
  for (int k = 0; k < size; ++k) {
    inFree.push_back(rows_->inFree(network_.offsets[body] + k));
    for (auto& [number, share] : inFree.back()) {
      int& place = local[std::size_t(number)];
      if (place < 0) {
        place = int(free.size());
        free.push_back(number);
      }
      number = place;
    }
  }
  const int numFree = int(free.size());
  DenseMatrix half(size, numFree), whole(numFree, numFree); // S T, T^T S T
  for (int k = 0; k < size; ++k)
    for (const auto& [place, share] : inFree[std::size_t(k)])
      for (int i = 0; i < size; ++i)
        half(i, place) += share * S(i, k);
  for (int j = 0; j < numFree; ++j)
    for (int k = 0; k < size; ++k)
      for (const auto& [place, share] : inFree[std::size_t(k)])
        whole(place, j) += share * half(k, j);
  for (int i = 0; i < numFree; ++i)
    for (int j = 0; j < numFree; ++j)
      if (free[std::size_t(i)] <= free[std::size_t(j)])
        entries.add(free[std::size_t(i)], free[std::size_t(j)], whole(i, j));
  for (const int number : free)
    local[std::size_t(number)] = -1;
}

SymmetricEntries NetworkProblem::reducedStiffness() const
{
  SymmetricEntries entries;
  entries.size = rows_->numFree();
  std::vector<int> local(std::size_t(entries.size), -1);
  for (std::size_t b = 0; b < network_.bodies.size(); ++b)
    addBody(b, local, entries);
  return entries;
}

bool NetworkProblem::holds(const std::vector<char>& closed)
{
  if (rows_ && closed == closed_)
    return factor_ != nullptr;
  rows_.emplace(network_.jump, tightestFirst(network_, closed), network_.bound, network_.size());
  closed_ = closed;
  stiffness_ = reducedStiffness();
  factor_.reset();
  try {
    factor_ = std::make_unique<SparseCholesky>(stiffness_);
    ledger_.count("interface factorisations");
  } catch (const NotPositiveDefinite&) {
    return false;
  }
  return true;
}

void NetworkProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  NDFRAME_ASSERT(proximal == 0.0, "sets that leave bodies free are solved by forces");
  if (!holds(closed))
    throw NotPositiveDefinite(-1);
  v_ = rows_->expanded(Vector(std::size_t(rows_->numFree()), 0.0));
  Vector rest = unbalanced(v_);
  for (int step = 0; step < 2; ++step) { // the second one is iterative refinement, mostly without need
    const Vector right = rows_->reduced(rest);
    if (step > 0 && largestEntry(right) <= statusRoundOff * largestEntry(network_.g))
      break;
    const Vector change = rows_->direction(factor_->solve(right));
    for (std::size_t k = 0; k < v_.size(); ++k)
      v_[k] += change[k];
    rest = unbalanced(v_);
  }
  pass.unbalanced = largestEntry(rows_->reduced(rest));
  for (double& value : rest)
    value = -value;
  pass.force = rows_->forces(rest);
  setDisplacement(network_, v_, pass);
}

/// One of NetworkBodies, counted.
Vector NetworkProblem::unbalanced(const Vector& v) const
{
  ledger_.count("interface products");
  return bodies_.unbalanced(v, 0.0, v);
}

} // namespace ndframe
