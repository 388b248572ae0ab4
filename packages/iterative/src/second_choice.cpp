#include <type_traits>
#include <utility>

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/algebra/neumann_solver.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "rank_problem.hpp"
#include "solvers.hpp"

namespace ndframe
{

namespace
{

/// A body by one solver, and by another from the solve on that the first one fails in.
class BodyWithSecondChoice final : public CondensedBody, public NeumannSolver, public WholeSolver
{
public:
  BodyWithSecondChoice(std::unique_ptr<CondensedBody> first, std::shared_ptr<const LinearSolver> second,
                       RankProblem problem, const Comm& comm, Ledger& ledger)
      : body_(std::move(first)), second_(std::move(second)), comm_(comm), ledger_(ledger)
  {
    if (wholeSolver(*body_) == nullptr || problem.kept.empty())
      problem_ = std::move(problem);
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    return either([&] { return body_->expand(load, kept); });
  }
  DenseMatrix reduce(const DenseMatrix& load) const override
  {
    return either([&] { return body_->reduce(load); });
  }
  Vector applySchur(const Vector& kept) const override
  {
    return either([&] { return body_->applySchur(kept); });
  }
  DenseMatrix schurComplement() const override
  {
    return either([&] { return body_->schurComplement(); });
  }
  Vector solveNeumann(const Vector& force) const override
  {
    return either([&] { return neumannSolver(*body_).solveNeumann(force); });
  }

  bool hasCheapSchur() const override { return body_->hasCheapSchur(); }
  std::string description() const override { return body_->description(); }
  void forgetSolutions() const override { body_->forgetSolutions(); }
  bool solvesNeumann() const override { return neumannSolver(*body_).solvesNeumann(); }
  const FreeMotions& freeMotions() const override { return neumannSolver(*body_).freeMotions(); }

  bool solvesWhole() const override { return wholeSolver(*body_) != nullptr; }
  const RankProblem& freedProblem() const override { return wholeSolver(*body_)->freedProblem(); }
  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    return wholeSolver(*body_)->join(bodies, open);
  }
  NodalField solveFree(const NodalField& load, NodalField start, Exactness exactness) const override
  {
    return wholeSolver(*body_)->solveFree(load, std::move(start), exactness);
  }
  void setLargestEigenvalue(double value) const override
  {
    if (solvesWhole())
      wholeSolver(*body_)->setLargestEigenvalue(value);
  }
  void forget() const override
  {
    if (solvesWhole())
      wholeSolver(*body_)->forget();
  }
  bool givesUp() const override
  {
    if (second_)
      takeSecond();
    return wholeSolver(*body_) == nullptr;
  }

private:
  template <class Solve>
  std::invoke_result_t<Solve> either(const Solve& solve) const
  {
    if (!second_)
      return solve();
    try {
      return solve();
    } catch (const NotConverged&) {
    } catch (const SingularBody&) {
    }
    takeSecond();
    return solve();
  }

  void takeSecond() const
  {
    if (problem_.matrix == nullptr) // the body has it but for the roles of kept dofs
      problem_ = withKeptDofsAs(DofRole::Kept, freedProblem());
    body_.reset(); // its memory is needed
    body_ = std::exchange(second_, nullptr)->factor(onAllRanks(std::exchange(problem_, {}), comm_), comm_, ledger_);
    ledger_.count("solvers given up");
  }

  mutable std::unique_ptr<CondensedBody> body_;
  mutable std::shared_ptr<const LinearSolver> second_; ///< null once it is taken
  mutable RankProblem problem_;                        ///< empty where the first body has it
  Comm comm_;
  Ledger& ledger_;
};

class SolverWithSecondChoice final : public LinearSolver
{
public:
  SolverWithSecondChoice(std::unique_ptr<LinearSolver> first, std::unique_ptr<LinearSolver> second)
      : first_(std::move(first)), second_(std::move(second))
  {}

  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    RankProblem held = heldPart(problem, !problem.edgeNodes.ends.empty());
    auto first = first_->factor(std::move(problem), comm, ledger);
    return std::make_unique<BodyWithSecondChoice>(std::move(first), second_, std::move(held), comm, ledger);
  }
  std::string name(int ranks) const override { return first_->name(ranks); }
  bool needsMpi(int ranks) const override { return first_->needsMpi(ranks) || second_->needsMpi(ranks); }

private:
  std::unique_ptr<LinearSolver> first_;
  std::shared_ptr<const LinearSolver> second_;
};

} // namespace

std::unique_ptr<LinearSolver> makeWithSecondChoice(std::unique_ptr<LinearSolver> first,
                                                   std::unique_ptr<LinearSolver> second)
{
  return std::make_unique<SolverWithSecondChoice>(std::move(first), std::move(second));
}

} // namespace ndframe
