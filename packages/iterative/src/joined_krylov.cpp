#include "joined_krylov.hpp"

#include "cycle_count.hpp"
#include "joined_equations.hpp"
#include "joined_level.hpp"
#include "own_dofs.hpp"

namespace ndframe
{

namespace
{

/// The coarse level is set up again where more than this share of its kept dofs has changed rows.
constexpr double staleShare = 0.04;
/// The same while the vertices are solved by themselves: they take many iterations in the time of a set-up.
constexpr double staleShareOnVertices = 0.25;

/// The levels of the bodies, with those of their kept dofs that are at vertices as kept ones of their own, -1
/// elsewhere.
std::vector<std::unique_ptr<LinearLevel>> levelsOf(const std::vector<const RankProblem*>& problems, const Comm& comm)
{
  std::vector<std::unique_ptr<LinearLevel>> levels;
  for (const RankProblem* problem : problems) {
    levels.push_back(std::make_unique<LinearLevel>(*problem, comm));
    for (std::size_t k = 0; k < problem->kept.size(); ++k) { // a vertex has the number of its node
      const auto& [a, b] = problem->keptEnds[k];
      levels.back()->problem.kept.push_back(a == b ? problem->kept[k] : -1);
    }
  }
  return levels;
}

std::vector<const RankProblem*> problemsOf(const std::vector<std::unique_ptr<LinearLevel>>& levels)
{
  std::vector<const RankProblem*> problems;
  for (const auto& level : levels)
    problems.push_back(&level->problem);
  return problems;
}

class JoinedKrylov final : public JoinedSystem
{
public:
  JoinedKrylov(const std::vector<const RankProblem*>& problems, const JoinedRows& open, const Comm& comm,
               Ledger& ledger, KrylovOptions options, const MakeJoinedGradients& make)
      : comm_(comm), ledger_(ledger), options_(options), levels_(levelsOf(problems, comm)), all_(problems, comm),
        vertices_(problemsOf(levels_), comm)
  {
    JoinedBodies bodies{problems, {}, all_.keptNumbers(), vertices_.keptNumbers()};
    for (const auto& level : levels_)
      bodies.levels.push_back(level.get());
    gradients_ = make(bodies, all_.unknowns(open, 0.0), comm_);
    for (const auto& level : levels_) // the gradients have what they need of it
      level->interpolation = {};
  }

  bool follow(const JoinedRows& rows, const JoinedRows& onVertices, double springs) override
  {
    const JoinedUnknowns unknowns = all_.unknowns(rows, springs);
    all_.follow(unknowns, *gradients_);
    return refresh(onVertices, springs, unknowns.springs, staleShare);
  }

  void begin(const std::vector<NodalField>& fields) override { all_.begin(all_.own().part(fields)); }

  Vector solve(const std::vector<const SparseField*>& loads, Vector& kept, double tolerance) override
  {
    int iterations = 0;
    Vector rest =
        all_.improve(all_.own().part(loads), kept, tolerance, options_.maxIterations, *gradients_, ledger_, iterations);
    ledger_.count("Krylov solves");
    ledger_.count("Krylov iterations", iterations);
    work_.enter(gradients_->work(), comm_, ledger_);
    return rest;
  }

  void beginOnVertices(const JoinedRows& open) override
  {
    onVertices_ = &gradients_->onVertices(vertices_.unknowns(open, 0.0));
  }

  bool followOnVertices(const JoinedRows& rows, double springs) override
  {
    const JoinedUnknowns unknowns = vertices_.unknowns(rows, springs);
    vertices_.follow(unknowns, *onVertices_);
    // springs differ from those of all nodes, whose coarse level is another one
    return refresh(rows, -springs, unknowns.springs, staleShareOnVertices);
  }

  Vector solveOnVertices(const std::vector<const SparseField*>& loads, Vector& kept, double tolerance) override
  {
    int iterations = 0;
    Vector rest = vertices_.improve(gradients_->toVertices(all_.own().part(loads)), kept, tolerance,
                                    options_.maxIterations, *onVertices_, ledger_, iterations);
    ledger_.count("vertex iterations", iterations);
    workOnVertices_.enter(onVertices_->work(), comm_, ledger_);
    return rest;
  }

  Vector beginFromVertices() override
  {
    all_.begin(gradients_->fromVertices(vertices_.u()));
    return all_.own().atKept(all_.u());
  }

  std::vector<NodalField> fields() const override { return all_.own().fields(all_.u()); }
  std::vector<NodalField> takeFields() && override
  {
    gradients_.reset(); // their memory is needed
    levels_.clear();
    return fields();
  }
  double tolerance() const override { return options_.tolerance; }
  const Comm& comm() const override { return comm_; }
  double largestEigenvalue() const { return gradients_->largestEigenvalue(); }

private:
  /// springs: those of kept dofs, `weight` times a diagonal. Whether the coarse level was set up.
  bool refresh(const JoinedRows& onVertices, double weight, const Vector& springs, double share)
  {
    if (!isStale(onVertices, weight, share))
      return false;
    auto level = std::make_unique<const JoinedLevel>(levels_, vertices_.keptNumbers(), onVertices, springs, comm_);
    gradients_->setCoarse(onVertices, level->problem, meanDiagonal(level->matrix, comm_), [&] { level.reset(); });
    coarseRows_ = onVertices;
    coarseSprings_ = weight;
    ledger_.count("multigrid set-ups");
    work_.enter(gradients_->work(), comm_, ledger_);
    return true;
  }

  bool isStale(const JoinedRows& onVertices, double springs, double share) const
  {
    if (coarseRows_.kept.empty() || springs != coarseSprings_)
      return true;
    std::size_t vertices = 0, changed = 0;
    for (std::size_t k = 0; k < onVertices.kept.size(); ++k) {
      vertices += vertices_.keptNumbers()[k] >= 0;
      changed += onVertices.kept[k] != coarseRows_.kept[k];
    }
    return double(changed) > share * double(vertices);
  }

  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  std::vector<std::unique_ptr<LinearLevel>> levels_;
  JoinedEquations all_, vertices_;
  std::unique_ptr<JoinedGradients> gradients_;
  FollowingGradients* onVertices_ = nullptr; ///< of the gradients
  JoinedRows coarseRows_;
  double coarseSprings_ = 0.0;
  CycleCount work_, workOnVertices_{"vertex products", "vertex cycles"};
};

} // namespace

std::unique_ptr<JoinedSystem> makeJoinedKrylov(const std::vector<const RankProblem*>& problems, const JoinedRows& open,
                                               const Comm& comm, Ledger& ledger, KrylovOptions options,
                                               const MakeJoinedGradients& make, double& largestEigenvalue)
{
  auto joined = std::make_unique<JoinedKrylov>(problems, open, comm, ledger, options, make);
  largestEigenvalue = joined->largestEigenvalue();
  return joined;
}

std::unique_ptr<JoinedSystem> joinBodies(const std::vector<const WholeSolver*>& bodies, const JoinedRows& open,
                                         const Comm& comm, Ledger& ledger, KrylovOptions options,
                                         const MakeJoinedGradients& make)
{
  std::vector<const RankProblem*> problems;
  for (const WholeSolver* body : bodies)
    problems.push_back(&body->freedProblem());
  double largest = 0.0;
  auto joined = makeJoinedKrylov(problems, open, comm, ledger, options, make, largest);
  for (const WholeSolver* body : bodies)
    body->setLargestEigenvalue(largest);
  return joined;
}

} // namespace ndframe
