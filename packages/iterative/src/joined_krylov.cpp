#include "joined_krylov.hpp"

#include <algorithm>
#include <cmath>

#include "cycle_count.hpp"
#include "joined_level.hpp"
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
      : problems_(std::move(problems)), comm_(comm), ledger_(ledger), options_(options)
  {
    for (const SolverProblem* problem : problems_)
      levels_.push_back(std::make_unique<LinearLevel>(*problem, comm));
    kept_ = numberKept(problems_, levels_);
    std::size_t size = 0;
    for (const SolverProblem* problem : problems_)
      size += problem->roles.size();
    isKept_.assign(size, 0);
    for (const int dof : kept_.dofs)
      isKept_[std::size_t(dof)] = 1;
    JoinedBodies bodies{problems_, {}, kept_.dofs, kept_.coarse};
    for (const auto& level : levels_)
      bodies.levels.push_back(level.get());
    gradients_ = make(bodies, {open, diagonal(open), {}}, comm_);
  }

  void follow(const JoinedRows& rows, const JoinedRows& onVertices, double springs) override
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
    if (isStale(onVertices, springs))
      setCoarse(onVertices, springs);
  }

  std::vector<Vector> solve(const std::vector<Vector>& loads, std::vector<Vector>& u, double tolerance) override
  {
    const std::vector<Vector> centre = u;
    std::vector<Vector> rest;
    Vector right;
    const auto residual = [&] {
      rest = unbalanced(loads, u);
      right = reduced(rest, u, centre);
      return norm(right);
    };
    const double first = residual(), reference = appliedForce(loads, rest);
    const int iterations = restartedGradients(
        tolerance * reference, reference, options_.maxIterations, first, ledger_,
        [&](double reduction, int most, const auto& watch) {
          ConjugateGradients::Result step = gradients_->solve(right, reduction, most, watch);
          comm_.sum(step.x);
          add(step.x, u);
          return step.iterations;
        },
        residual, [&] { return roundOff(u); });
    ledger_.count("Krylov solves");
    ledger_.count("Krylov iterations", iterations);
    work_.enter(gradients_->work(), ledger_);
    return rest;
  }

  double tolerance() const override { return options_.tolerance; }

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
    const JoinedLevel level(levels_, kept_.coarse, onVertices, springs_, comm_);
    gradients_->setCoarse(onVertices, level.problem, meanDiagonal(level.matrix, comm_));
    coarseRows_ = onVertices;
    coarseSprings_ = springs;
    ledger_.count("multigrid set-ups");
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

  /// load - K u, zero on fixed dofs.
  std::vector<Vector> unbalanced(const std::vector<Vector>& loads, const std::vector<Vector>& u) const
  {
    std::vector<Vector> rest;
    for (std::size_t b = 0; b < u.size(); ++b) {
      rest.push_back(multiply(*problems_[b]->matrix, u[b], comm_));
      for (std::size_t i = 0; i < rest.back().size(); ++i)
        rest.back()[i] = problems_[b]->roles[i] == DofRole::Fixed ? 0.0 : loads[b][i] - rest.back()[i];
    }
    work_.addResidual();
    return rest;
  }

  /// E^T rest, and what the springs do, of all bodies.
  Vector reduced(const std::vector<Vector>& rest, const std::vector<Vector>& u, const std::vector<Vector>& centre) const
  {
    Vector all;
    for (const Vector& body : rest)
      all.insert(all.end(), body.begin(), body.end());
    Vector forces(kept_.dofs.size(), 0.0), moved(kept_.dofs.size(), 0.0);
    for (std::size_t k = 0; k < kept_.dofs.size(); ++k) {
      const auto& [body, dof] = kept_.of[k];
      moved[k] = u[std::size_t(body)][std::size_t(dof)] - centre[std::size_t(body)][std::size_t(dof)];
      for (const auto& [place, share] : rows_.kept[k])
        forces[std::size_t(place)] += share * rest[std::size_t(body)][std::size_t(dof)];
    }
    for (std::size_t p = 0; p < springs_.size(); ++p)
      for (const auto& [k, share] : rows_.unknowns[p])
        forces[p] -= springs_[p] * share * moved[std::size_t(k)];
    for (std::size_t k = 0; k < kept_.dofs.size(); ++k)
      all[std::size_t(kept_.dofs[k])] = forces[k];
    return all;
  }

  /// u += E x
  void add(const Vector& x, std::vector<Vector>& u) const
  {
    std::size_t first = 0;
    for (std::size_t b = 0; b < u.size(); ++b) {
      for (std::size_t i = 0; i < u[b].size(); ++i)
        if (problems_[b]->roles[i] == DofRole::Interior && !isKept_[first + i])
          u[b][i] += x[first + i];
      first += u[b].size();
    }
    for (std::size_t k = 0; k < kept_.dofs.size(); ++k)
      for (const auto& [place, share] : rows_.kept[k])
        u[std::size_t(kept_.of[k].first)][std::size_t(kept_.of[k].second)] +=
            share * x[std::size_t(kept_.dofs[std::size_t(place)])];
  }

  /// The loads and the forces that kept dofs take from each other.
  double appliedForce(const std::vector<Vector>& loads, const std::vector<Vector>& rest) const
  {
    double squares = 0.0;
    for (std::size_t b = 0; b < loads.size(); ++b)
      for (std::size_t i = 0; i < loads[b].size(); ++i)
        if (problems_[b]->roles[i] != DofRole::Fixed)
          squares += loads[b][i] * loads[b][i];
    for (const auto& [body, dof] : kept_.of)
      squares += rest[std::size_t(body)][std::size_t(dof)] * rest[std::size_t(body)][std::size_t(dof)];
    return std::sqrt(squares);
  }

  double roundOff(const std::vector<Vector>& u) const
  {
    double squares = 0.0;
    for (std::size_t b = 0; b < u.size(); ++b) {
      const double own = productRoundOff(*problems_[b]->matrix, u[b], comm_);
      squares += own * own;
    }
    return std::sqrt(squares);
  }

  std::vector<const SolverProblem*> problems_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  std::vector<std::unique_ptr<LinearLevel>> levels_;
  KeptNumbers kept_;
  std::vector<char> isKept_; ///< per dof of all bodies
  std::unique_ptr<JoinedGradients> gradients_;
  JoinedRows rows_, coarseRows_;
  double coarseSprings_ = 0.0;
  Vector springs_; ///< per kept dof; empty: none
  mutable CycleCount work_;
};

} // namespace

std::unique_ptr<JoinedSystem> makeJoinedKrylov(std::vector<const SolverProblem*> problems, const JoinedRows& open,
                                               const Comm& comm, Ledger& ledger, KrylovOptions options,
                                               const MakeJoinedGradients& make)
{
  return std::make_unique<JoinedKrylov>(std::move(problems), open, comm, ledger, options, make);
}

} // namespace ndframe
