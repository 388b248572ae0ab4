#include "joined_equations.hpp"

#include <cmath>

#include "restarted_gradients.hpp"

namespace ndframe
{

namespace
{

/// K_ij of a body on the rank that has the row, zero elsewhere.
double entry(const BlockMatrix& K, RankProblem::Global i, RankProblem::Global j)
{
  const int row = K.rowOf(i / K.dim), column = K.nodes.local(j / K.dim);
  if (row < 0 || column < 0)
    return 0.0;
  const double* block = K.block(row, column);
  return block == nullptr ? 0.0 : block[(i % K.dim) * K.dim + j % K.dim];
}

} // namespace

JoinedEquations::JoinedEquations(std::vector<const RankProblem*> problems, const Comm& comm)
    : problems_(std::move(problems)), comm_(comm), own_(problems_, comm), u_(own_.size(), 0.0)
{
  RankProblem::Global first = 0;
  for (std::size_t b = 0; b < problems_.size(); ++b) {
    for (const RankProblem::Global dof : problems_[b]->kept) {
      kept_.emplace_back(int(b), dof);
      numbers_.push_back(dof < 0 ? -1 : first + dof);
    }
    first += problems_[b]->matrix->nodes.globalSize() * problems_[b]->matrix->dim;
  }
}

JoinedUnknowns JoinedEquations::unknowns(const JoinedRows& rows, double springs) const
{
  JoinedUnknowns unknowns{rows, diagonal(rows), {}};
  if (springs > 0.0)
    for (double& value : unknowns.diagonal) {
      unknowns.springs.push_back(springs * value);
      value += unknowns.springs.back();
    }
  return unknowns;
}

void JoinedEquations::follow(const JoinedUnknowns& unknowns, FollowingGradients& gradients)
{
  rows_ = unknowns.rows;
  springs_ = unknowns.springs;
  gradients.follow(unknowns);
}

Vector JoinedEquations::improve(const Vector& load, Vector& kept, double tolerance, int maxIterations,
                                const FollowingGradients& gradients, const Ledger& ledger, int& iterations)
{
  const Vector centre = kept;
  own_.setKept(kept, u_);
  Vector rest, right;
  const auto residual = [&] {
    right = unbalanced(load, gradients);
    rest = own_.atKept(right);
    own_.setKept(reduced(rest, kept, centre), right);
    return own_.norm(right);
  };
  const double first = residual(), reference = std::hypot(own_.norm(load), norm(rest));
  iterations += restartedGradients(
      tolerance * reference, reference, maxIterations, first, ledger,
      [&](double reduction, int most, const auto& watch) {
        const ConjugateGradients::Result step = gradients.solve(right, reduction, most, watch);
        add(step.x, kept);
        return step.iterations;
      },
      residual, [&] { return rowRoundOff * own_.norm(gradients.sizes(u_)); });
  return rest;
}

/// Of E^T K E, at the places of unknowns.
Vector JoinedEquations::diagonal(const JoinedRows& rows) const
{
  const auto readers = transposed(rows.kept, int(rows.kept.size()));
  Vector result(readers.size(), 0.0);
  for (std::size_t p = 0; p < readers.size(); ++p)
    for (const auto& [k, first] : readers[p])
      for (const auto& [l, second] : readers[p]) {
        const auto& [body, i] = kept_[std::size_t(k)];
        const auto& [other, j] = kept_[std::size_t(l)];
        if (body == other)
          result[p] += first * second * entry(*problems_[std::size_t(body)]->matrix, i, j);
      }
  comm_.sum(result);
  return result;
}

/// load - K u on the free dofs of this rank.
Vector JoinedEquations::unbalanced(const Vector& load, const FollowingGradients& gradients) const
{
  Vector rest = gradients.multiply(u_);
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = load[i] - rest[i];
  return rest;
}

/// E^T rest, and what the springs do, at the kept dofs.
Vector JoinedEquations::reduced(const Vector& rest, const Vector& kept, const Vector& centre) const
{
  Vector forces(rest.size(), 0.0);
  for (std::size_t k = 0; k < rest.size(); ++k)
    for (const auto& [place, share] : rows_.kept[k])
      forces[std::size_t(place)] += share * rest[k];
  for (std::size_t p = 0; p < springs_.size(); ++p)
    for (const auto& [k, share] : rows_.unknowns[p])
      forces[p] -= springs_[p] * share * (kept[std::size_t(k)] - centre[std::size_t(k)]);
  return forces;
}

/// u += E x
void JoinedEquations::add(const Vector& x, Vector& kept)
{
  for (std::size_t i = 0; i < u_.size(); ++i)
    if (own_.isInside(i)) // multigrid leaves round-off in the decoupled rows
      u_[i] += x[i];
  const Vector unknowns = own_.atKept(x);
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (const auto& [place, share] : rows_.kept[k])
      kept[k] += share * unknowns[std::size_t(place)];
  own_.setKept(kept, u_);
}

} // namespace ndframe
