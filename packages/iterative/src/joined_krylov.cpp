#include "joined_krylov.hpp"

#include <algorithm>
#include <cmath>

#include "cycle_count.hpp"
#include "joined_level.hpp"
#include "ndframe/base/memory.hpp"
#include "own_dofs.hpp"
#include "restarted_gradients.hpp"

namespace ndframe
{

namespace
{

/// The coarse level is set up again where more than this share of its kept dofs has changed rows.
constexpr double staleShare = 0.04;

/// One number for each kept dof of all bodies.
struct KeptNumbers
{
  std::vector<int> dofs, coarse;       ///< among all, -1: not at a vertex
  std::vector<std::pair<int, int>> of; ///< body and its dof
};

KeptNumbers numberKept(const std::vector<const SolverProblem*>& problems,
                       const std::vector<std::unique_ptr<LinearLevel>>& levels)
{
  KeptNumbers numbers;
  int first = 0, coarseFirst = 0;
  for (std::size_t b = 0; b < problems.size(); ++b) {
    const int dim = problems[b]->matrix->dim;
    const LinearInterpolation& P = levels[b]->interpolation;
    for (const int dof : problems[b]->kept) {
      const auto& ends = P.ends[std::size_t(dof / dim)];
      numbers.of.emplace_back(int(b), dof);
      numbers.dofs.push_back(first + dof);
      numbers.coarse.push_back(ends[0] == ends[1] ? coarseFirst + ends[0] * dim + dof % dim : -1);
    }
    first += problems[b]->matrix->numDofs();
    coarseFirst += levels[b]->matrix.numDofs();
  }
  return numbers;
}

/// K_ij of a body on the rank that has the row, zero elsewhere.
double entry(const BlockMatrix& K, int i, int j)
{
  const int row = K.rowOf(i / K.dim), column = K.nodes.local(j / K.dim);
  if (row < 0 || column < 0)
    return 0.0;
  const double* block = K.block(row, column);
  return block == nullptr ? 0.0 : block[(i % K.dim) * K.dim + j % K.dim];
}

class JoinedKrylov final : public JoinedSystem
{
public:
  JoinedKrylov(std::vector<const SolverProblem*> problems, const JoinedRows& open, const Comm& comm, Ledger& ledger,
               KrylovOptions options, const MakeJoinedGradients& make)
      : problems_(std::move(problems)), comm_(comm), ledger_(ledger), options_(options), own_(problems_, comm),
        u_(own_.size(), 0.0)
  {
    for (const SolverProblem* problem : problems_)
      levels_.push_back(std::make_unique<LinearLevel>(*problem, comm));
    kept_ = numberKept(problems_, levels_);
    JoinedBodies bodies{problems_, {}, kept_.dofs, kept_.coarse};
    for (const auto& level : levels_)
      bodies.levels.push_back(level.get());
    gradients_ = make(bodies, {open, diagonal(open), {}}, comm_);
    for (const auto& level : levels_) // the gradients have what they need of it, and it is as large as all bodies
      level->interpolation = LinearInterpolation({}, level->interpolation.dim);
  }

  bool follow(const JoinedRows& rows, const JoinedRows& onVertices, double springs) override
  {
    rows_ = rows;
    JoinedUnknowns unknowns{rows, diagonal(rows), {}};
    springs_.clear();
    if (springs > 0.0)
      for (double& value : unknowns.diagonal) {
        springs_.push_back(springs * value);
        value += springs_.back();
      }
    unknowns.springs = springs_;
    gradients_->follow(unknowns);
    const bool isSetUp = isStale(onVertices, springs);
    if (isSetUp)
      setCoarse(onVertices, springs);
    return isSetUp;
  }

  void begin(const std::vector<const Vector*>& fields) override { u_ = own_.part(fields); }

  Vector solve(const std::vector<const SparseField*>& loads, Vector& kept, double tolerance) override
  {
    const Vector load = own_.part(loads), centre = kept;
    own_.setKept(kept, u_);
    Vector rest, right;
    const auto residual = [&] {
      right = unbalanced(load);
      rest = own_.atKept(right);
      own_.setKept(reduced(rest, kept, centre), right);
      return own_.norm(right);
    };
    const double first = residual(), reference = std::hypot(own_.norm(load), norm(rest));
    const int iterations = restartedGradients(
        tolerance * reference, reference, options_.maxIterations, first, ledger_,
        [&](double reduction, int most, const auto& watch) {
          const ConjugateGradients::Result step = gradients_->solve(right, reduction, most, watch);
          add(step.x, kept);
          return step.iterations;
        },
        residual, [&] { return roundOff(); });
    ledger_.count("Krylov solves");
    ledger_.count("Krylov iterations", iterations);
    work_.enter(gradients_->work(), comm_, ledger_);
    return rest;
  }

  std::vector<Vector> fields() const override { return own_.gathered(u_); }
  std::vector<Vector> takeFields() && override
  {
    gradients_.reset(); // their memory is needed
    levels_.clear();
    return own_.gathered(u_);
  }
  double tolerance() const override { return options_.tolerance; }
  double largestEigenvalue() const { return gradients_->largestEigenvalue(); }

private:
  bool isStale(const JoinedRows& onVertices, double springs) const
  {
    if (coarseRows_.kept.empty() || springs != coarseSprings_)
      return true;
    std::size_t vertices = 0, changed = 0;
    for (std::size_t k = 0; k < kept_.coarse.size(); ++k) {
      vertices += kept_.coarse[k] >= 0;
      changed += onVertices.kept[k] != coarseRows_.kept[k];
    }
    return double(changed) > staleShare * double(vertices);
  }

  void setCoarse(const JoinedRows& onVertices, double springs)
  {
    auto level = std::make_unique<const JoinedLevel>(levels_, kept_.coarse, onVertices, springs_, comm_);
    gradients_->setCoarse(onVertices, level->problem, meanDiagonal(level->matrix, comm_), [&] {
      level.reset();
      giveBack();
    });
    coarseRows_ = onVertices;
    coarseSprings_ = springs;
    ledger_.count("multigrid set-ups");
    work_.enter(gradients_->work(), comm_, ledger_);
  }

  /// Before the set-up of the coarse levels, which is the largest moment of several ranks.
  void giveBack() const
  {
    if (comm_.size() > 1)
      giveBackFreed();
  }

  /// Of E^T K E, at the places of unknowns.
  Vector diagonal(const JoinedRows& rows) const
  {
    const auto readers = transposed(rows.kept, int(rows.kept.size()));
    Vector result(readers.size(), 0.0);
    for (std::size_t p = 0; p < readers.size(); ++p)
      for (const auto& [k, first] : readers[p])
        for (const auto& [l, second] : readers[p]) {
          const auto& [body, i] = kept_.of[std::size_t(k)];
          const auto& [other, j] = kept_.of[std::size_t(l)];
          if (body == other)
            result[p] += first * second * entry(*problems_[std::size_t(body)]->matrix, i, j);
        }
    comm_.sum(result);
    return result;
  }

  /// load - K u on the free dofs of this rank.
  Vector unbalanced(const Vector& load) const
  {
    Vector rest = gradients_->multiply(u_);
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = load[i] - rest[i];
    return rest;
  }

  /// E^T rest, and what the springs do, at the kept dofs.
  Vector reduced(const Vector& rest, const Vector& kept, const Vector& centre) const
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
  void add(const Vector& x, Vector& kept)
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

  double roundOff() const { return rowRoundOff * own_.norm(gradients_->sizes(u_)); }

  std::vector<const SolverProblem*> problems_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  OwnDofs own_;
  Vector u_; ///< per own dof
  std::vector<std::unique_ptr<LinearLevel>> levels_;
  KeptNumbers kept_;
  std::unique_ptr<JoinedGradients> gradients_;
  JoinedRows rows_, coarseRows_;
  double coarseSprings_ = 0.0;
  Vector springs_; ///< per kept dof; empty: none
  mutable CycleCount work_;
};

} // namespace

std::unique_ptr<JoinedSystem> makeJoinedKrylov(std::vector<const SolverProblem*> problems, const JoinedRows& open,
                                               const Comm& comm, Ledger& ledger, KrylovOptions options,
                                               const MakeJoinedGradients& make, double& largestEigenvalue)
{
  auto joined = std::make_unique<JoinedKrylov>(std::move(problems), open, comm, ledger, options, make);
  largestEigenvalue = joined->largestEigenvalue();
  return joined;
}

} // namespace ndframe
