#include "krylov_share.hpp"

#include <fmt/format.h>

#include "freed_system.hpp"
#include "joined_krylov.hpp"
#include "ndframe/algebra/neumann_solver.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "rank_problem.hpp"

namespace ndframe
{

namespace
{

[[noreturn]] void refuse()
{
  throw InternalError("a body that no rank has as a whole was asked for vectors of all its dofs");
}

class KrylovShare final : public CondensedBody, public NeumannSolver, public WholeSolver
{
public:
  KrylovShare(RankProblem problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
              MakeConjugateGradients makeCg, MakeJoinedGradients makeJoined, std::string description)
      : freed_(withKeptDofsAs(DofRole::Interior, std::move(problem)), comm, ledger, options, std::move(makeCg), true),
        comm_(comm), ledger_(ledger), options_(options), makeJoined_(std::move(makeJoined)),
        description_(fmt::format("{}, tolerance {:.0e}", description, options.tolerance))
  {}

  bool solvesWhole() const override { return true; }
  const RankProblem& freedProblem() const override { return freed_.problem(); }
  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    return joinBodies(bodies, open, comm_, ledger_, options_, makeJoined_);
  }
  void setLargestEigenvalue(double value) const override { freed_.setLargestEigenvalue(value); }
  NodalField solveFree(const NodalField& load, NodalField start, Exactness exactness) const override
  {
    return freed_.solve(load, start, exactness);
  }
  void forget() const override { freed_.forget(); }
  void forgetSolutions() const override { freed_.forgetSolutions(); }
  std::string description() const override { return description_; }

  DenseMatrix expand(const DenseMatrix&, const DenseMatrix&) const override { refuse(); }
  DenseMatrix reduce(const DenseMatrix&) const override { refuse(); }
  Vector applySchur(const Vector&) const override { refuse(); }
  Vector solveNeumann(const Vector&) const override { refuse(); }
  bool solvesNeumann() const override { return true; } // so that nobody asks for S
  const FreeMotions& freeMotions() const override { refuse(); }
  DenseMatrix schurComplement() const override { refuse(); }
  bool hasCheapSchur() const override { return false; }

private:
  FreedSystem freed_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  MakeJoinedGradients makeJoined_;
  std::string description_;
};

} // namespace

std::unique_ptr<CondensedBody> makeKrylovShare(RankProblem problem, const Comm& comm, Ledger& ledger,
                                               KrylovOptions options, MakeConjugateGradients makeCg,
                                               MakeJoinedGradients makeJoined, std::string description)
{
  return std::make_unique<KrylovShare>(std::move(problem), comm, ledger, options, std::move(makeCg),
                                       std::move(makeJoined), std::move(description));
}

} // namespace ndframe
