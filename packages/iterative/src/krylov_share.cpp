#include "krylov_share.hpp"

#include <fmt/format.h>

#include "joined_krylov.hpp"
#include "ndframe/algebra/neumann_solver.hpp"
#include "ndframe/base/diagnostics.hpp"

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
              MakeJoinedGradients makeJoined, std::string description)
      : freed_(std::move(problem)), comm_(comm), ledger_(ledger), options_(options), makeJoined_(std::move(makeJoined)),
        description_(fmt::format("{}, tolerance {:.0e}", description, options.tolerance))
  {
    for (const RankProblem::Global kept : freed_.kept)
      if (const int dof = freed_.held(kept); dof >= 0)
        freed_.roles[std::size_t(dof)] = DofRole::Interior;
  }

  bool solvesWhole() const override { return true; }
  const RankProblem& freedProblem() const override { return freed_; }
  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    double largestEigenvalue = 0.0;
    std::vector<const RankProblem*> problems;
    for (const WholeSolver* body : bodies)
      problems.push_back(&body->freedProblem());
    return makeJoinedKrylov(problems, open, comm_, ledger_, options_, makeJoined_, largestEigenvalue);
  }
  std::string description() const override { return description_; }

  void forget() const override {} // it keeps nothing
  Vector solveFree(const Vector&, Vector, Exactness) const override { refuse(); }
  DenseMatrix expand(const DenseMatrix&, const DenseMatrix&) const override { refuse(); }
  DenseMatrix reduce(const DenseMatrix&) const override { refuse(); }
  Vector applySchur(const Vector&) const override { refuse(); }
  Vector solveNeumann(const Vector&) const override { refuse(); }
  bool solvesNeumann() const override { return true; } // so that nobody asks for S
  const FreeMotions& freeMotions() const override { refuse(); }
  DenseMatrix schurComplement() const override { refuse(); }
  bool hasCheapSchur() const override { return false; }

private:
  RankProblem freed_; ///< with the kept dofs as interior ones
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  MakeJoinedGradients makeJoined_;
  std::string description_;
};

} // namespace

std::unique_ptr<CondensedBody> makeKrylovShare(RankProblem problem, const Comm& comm, Ledger& ledger,
                                               KrylovOptions options, MakeJoinedGradients makeJoined,
                                               std::string description)
{
  return std::make_unique<KrylovShare>(std::move(problem), comm, ledger, options, std::move(makeJoined),
                                       std::move(description));
}

} // namespace ndframe
