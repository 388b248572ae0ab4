#include "network_problem.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Of the largest diagonal entry: the least that the proximal term counts as stiffness.
constexpr double softest = 1e-6;

/// Bodies in a network have stored operators.
const DenseMatrix& stored(const BodyTrace& body)
{
  const DenseMatrix* S = body.S->dense();
  NDFRAME_ASSERT(S != nullptr, "a network needs stored interface operators");
  return *S;
}

} // namespace

NetworkProblem::NetworkProblem(const Network& network, Ledger& ledger)
    : network_(network), ledger_(ledger), byBound_(network.bound.size())
{
  for (const BodyTrace* body : network.bodies)
    motions_.insert(motions_.end(), body->motionNames.begin(), body->motionNames.end());
  for (const BodyTrace* body : network.bodies)
    for (int k = 0; k < body->S->size(); ++k)
      diagonal_.push_back(stored(*body)(k, k));
  const double largest = largestEntry(diagonal_);
  for (double& value : diagonal_)
    value = largest > 0.0 ? std::max(value, softest * largest) : 1.0;
  std::iota(byBound_.begin(), byBound_.end(), 0);
  std::stable_sort(byBound_.begin(), byBound_.end(),
                   [&](int a, int b) { return network.bound[std::size_t(a)] < network.bound[std::size_t(b)]; });
}

Vector NetworkProblem::stiffTimes(const Vector& v) const
{
  Vector forces;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const Vector own =
        network_.bodies[b]->S->apply({v.begin() + network_.offsets[b], v.begin() + network_.offsets[b + 1]});
    forces.insert(forces.end(), own.begin(), own.end());
  }
  ledger_.count("interface products");
  return forces;
}

/// T^T S T of one body, T its entries of v in the free variables. local: per free variable -1, as it is left.
void NetworkProblem::addBody(std::size_t body, std::vector<int>& local, SymmetricEntries& entries) const
{
  const DenseMatrix& S = stored(*network_.bodies[body]);
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
  for (int k = 0; k < size; ++k)
    for (const auto& [place, share] : inFree[std::size_t(k)])
      for (int j = 0; j < numFree; ++j)
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
  std::vector<int> chosen;
  for (const int row : byBound_)
    if (closed[std::size_t(row)])
      chosen.push_back(row);
  rows_.emplace(network_.jump, chosen, network_.bound, network_.size());
  closed_ = closed;
  stiffness_ = reducedStiffness();
  factor_.reset();
  try {
    factor_ = std::make_shared<SparseCholesky>(stiffness_);
    ledger_.count("interface factorisations");
  } catch (const NotPositiveDefinite&) {
    return false;
  }
  return true;
}

void NetworkProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  if (!holds(closed) && proximal == 0.0)
    throw NotPositiveDefinite(-1);
  const Vector centre = v_.empty() ? Vector(diagonal_.size(), 0.0) : v_;
  const auto factor = proximal == 0.0 ? factor_ : std::make_shared<SparseCholesky>(shiftedStiffness(proximal));
  v_ = rows_->expanded(Vector(std::size_t(rows_->numFree()), 0.0));
  Vector rest = residual(v_, proximal, centre);
  for (int step = 0; step < 2; ++step) { // the second one is iterative refinement, mostly without need
    const Vector right = rows_->reduced(rest);
    if (step > 0 && largestEntry(right) <= statusRoundOff * largestEntry(network_.g))
      break;
    const Vector change = rows_->direction(factor->solve(right));
    for (std::size_t k = 0; k < v_.size(); ++k)
      v_[k] += change[k];
    rest = residual(v_, proximal, centre);
  }
  pass.unbalanced = largestEntry(rows_->reduced(proximal == 0.0 ? rest : residual(v_, 0.0, centre)));
  for (double& value : rest)
    value = -value;
  pass.force = rows_->forces(rest);
  pass.u = rowValues(network_.jump, Vector(network_.jump.size(), 0.0), v_);
  pass.displacement = largestEntry(v_);
  pass.load = largestEntry(network_.g);
}

/// g - S v - proximal D (v - v_c), D the diagonal of S, v_c the solution before.
Vector NetworkProblem::residual(const Vector& v, double proximal, const Vector& centre) const
{
  Vector rest = stiffTimes(v);
  for (std::size_t k = 0; k < rest.size(); ++k)
    rest[k] = network_.g[k] - rest[k] - proximal * diagonal_[k] * (v[k] - centre[k]);
  return rest;
}

/// Z^T (S + proximal D) Z.
SymmetricEntries NetworkProblem::shiftedStiffness(double proximal) const
{
  SymmetricEntries shifted = stiffness_;
  for (std::size_t v = 0; v < diagonal_.size(); ++v) {
    const SparseRow inFree = rows_->inFree(int(v));
    for (const auto& [i, first] : inFree)
      for (const auto& [j, second] : inFree)
        if (i <= j)
          shifted.add(i, j, proximal * diagonal_[v] * first * second);
  }
  return shifted;
}

} // namespace ndframe
