#include "anderson_mixing.hpp"

#include <algorithm>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t mixedSweeps = 8;
constexpr int mostRestarts = 4;
constexpr double dependent = 1e-10; ///< relative size below which a direction is round-off

DenseMatrix columns(const std::deque<Vector>& vectors)
{
  DenseMatrix matrix(int(vectors.front().size()), int(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j)
    std::copy(vectors[j].begin(), vectors[j].end(), matrix.col(int(j)));
  return matrix;
}

} // namespace

void AndersonMixing::start()
{
  *this = {};
}

void AndersonMixing::remember(const Vector& residual, const Vector& traction)
{
  if (norm(residual) > norm(residual_)) {
    residualChanges_.clear();
    tractionChanges_.clear();
    ++restarts_;
    return;
  }
  residualChanges_.push_back(difference(residual, residual_));
  tractionChanges_.push_back(difference(traction, traction_));
  if (residualChanges_.size() > mixedSweeps) {
    residualChanges_.pop_front();
    tractionChanges_.pop_front();
  }
}

InterfaceValues AndersonMixing::next(const InterfaceValues& dirichlet, const InterfaceValues& neumann, double theta)
{
  const Vector residual = difference(dirichlet, neumann);
  if (!residual_.empty() && restarts_ < mostRestarts)
    remember(residual, neumann);
  InterfaceValues next = relax(dirichlet, neumann, theta);
  if (!residualChanges_.empty()) {
    const Vector gamma = multiply(pseudoInverse(columns(residualChanges_), dependent), residual);
    for (std::size_t j = 0; j < gamma.size(); ++j)
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] -= gamma[j] * (tractionChanges_[j][i] + theta * residualChanges_[j][i]);
  }
  residual_ = residual;
  traction_ = neumann;
  return next;
}

RelaxationMemory AndersonMixing::memory() const
{
  RelaxationMemory memory{{double(restarts_)}, residual_, traction_};
  memory.insert(memory.end(), residualChanges_.begin(), residualChanges_.end());
  memory.insert(memory.end(), tractionChanges_.begin(), tractionChanges_.end());
  return memory;
}

bool AndersonMixing::recall(const RelaxationMemory& memory)
{
  constexpr std::size_t single = 3;
  if (memory.size() < single || memory.front().size() != 1 || (memory.size() - single) % 2 != 0)
    return false;
  restarts_ = int(memory.front().front());
  residual_ = memory[1];
  traction_ = memory[2];
  const auto first = memory.begin() + single, middle = first + (memory.end() - first) / 2;
  residualChanges_.assign(first, middle);
  tractionChanges_.assign(middle, memory.end());
  return true;
}

} // namespace ndframe
