#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/algebra/neumann_solver.hpp"

/// What every linear solver promises (linear_solver.hpp), against dense elimination on one rank.

namespace ndframe
{

namespace
{

struct Case
{
  const char* solver;
  std::vector<int> cells;
  test::Support support;
  double tolerance; ///< direct solvers: round-off; Krylov: its tolerance times the condition
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.solver << ", " << c.cells.size() << "-D";
}

class EverySolver : public testing::TestWithParam<Case>
{
protected:
  EverySolver()
      : body(test::trussBody(GetParam().cells, test::comm())), whole(test::trussBody(GetParam().cells, Comm::single())),
        problem(body.problem(GetParam().support)), reference(whole.problem(GetParam().support))
  {}

  void SetUp() override
  {
    if (test::comm().size() > 1 && std::string(GetParam().solver) == "Cholmod")
      GTEST_SKIP() << "Cholmod runs on one rank";
    condensed = test::makeSolver(GetParam().solver)->factor(problem, test::comm(), ledger);
  }

  Vector load(unsigned seed) const { return test::randomVector(std::size_t(body.matrix.numDofs()), seed); }
  Vector keptValues(unsigned seed) const { return test::randomVector(problem.kept.size(), seed); }
  double tolerance() const { return GetParam().tolerance; }
  const NeumannSolver& neumann() const { return neumannSolver(*condensed); }

  test::SampleBody body, whole;
  SolverProblem problem;
  test::DenseReference reference;
  Ledger ledger;
  std::unique_ptr<CondensedBody> condensed;
};

} // namespace

TEST_P(EverySolver, SchurComplementEqualsDenseElimination)
{
  const DenseMatrix S = condensed->schurComplement();
  EXPECT_LT(test::relativeDifference(S, reference.schur), tolerance());
  for (int i = 0; i < S.rows(); ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_EQ(S(i, j), S(j, i));
}

TEST_P(EverySolver, ApplySchurEqualsTheSchurComplementTimesTheVector)
{
  const Vector u = keptValues(1);
  EXPECT_LT(test::relativeDifference(condensed->applySchur(u), multiply(reference.schur, u)), tolerance());
}

TEST_P(EverySolver, ExpandEqualsDenseEliminationColumnByColumn)
{
  DenseMatrix loads(body.matrix.numDofs(), 3), kept(int(problem.kept.size()), 3);
  for (int j = 0; j < 3; ++j) {
    const Vector f = load(unsigned(j)), u = keptValues(unsigned(j) + 10);
    std::copy(f.begin(), f.end(), loads.col(j));
    std::copy(u.begin(), u.end(), kept.col(j));
  }
  const DenseMatrix u = condensed->expand(loads, kept);
  for (int j = 0; j < 3; ++j)
    EXPECT_LT(test::relativeDifference(u.column(j), reference.expand(loads.column(j), kept.column(j))), tolerance());
}

TEST_P(EverySolver, ExpandKeepsKeptAndFixedValuesExactly)
{
  const Vector given = keptValues(2);
  const DenseMatrix u = condensed->expand(DenseMatrix(load(3)), DenseMatrix(given));
  for (std::size_t c = 0; c < given.size(); ++c)
    EXPECT_EQ(u(problem.kept[c], 0), given[c]);
  for (std::size_t dof = 0; dof < problem.roles.size(); ++dof) {
    if (problem.roles[dof] == DofRole::Fixed) {
      EXPECT_EQ(u(int(dof), 0), 0.0);
    }
  }
}

TEST_P(EverySolver, ReduceEqualsDenseElimination)
{
  const Vector f = load(4);
  EXPECT_LT(test::relativeDifference(condensed->reduce(DenseMatrix(f)).column(0), reference.reduce(f)), tolerance());
}

TEST_P(EverySolver, CondensedReactionIsTheReactionOfTheExpandedDisplacement)
{
  const Vector f = load(5), kept = keptValues(6);
  const Vector u = condensed->expand(DenseMatrix(f), DenseMatrix(kept)).column(0);
  const Vector force = multiply(body.matrix, u, test::comm()), g = condensed->reduce(DenseMatrix(f)).column(0);
  Vector condensedReaction = multiplySymmetric(condensed->schurComplement(), kept), reaction;
  for (std::size_t c = 0; c < kept.size(); ++c) {
    condensedReaction[c] -= g[c];
    reaction.push_back(force[std::size_t(problem.kept[c])] - f[std::size_t(problem.kept[c])]);
  }
  EXPECT_LT(test::relativeDifference(condensedReaction, reaction), tolerance());
}

TEST_P(EverySolver, NothingGivenExpandsToNothing)
{
  const DenseMatrix u =
      condensed->expand(DenseMatrix(body.matrix.numDofs(), 1), DenseMatrix(int(problem.kept.size()), 1));
  EXPECT_EQ(norm(u.column(0)), 0.0);
  EXPECT_EQ(condensed->expand(DenseMatrix(body.matrix.numDofs(), 0), DenseMatrix(int(problem.kept.size()), 0)).cols(),
            0);
}

TEST_P(EverySolver, CountsOneBackSolvePerRightHandSide)
{
  const int n = int(problem.kept.size());
  condensed->expand(DenseMatrix(body.matrix.numDofs(), 3), DenseMatrix(n, 3));
  EXPECT_EQ(ledger.counted("back-solves"), 3);
  condensed->reduce(DenseMatrix(body.matrix.numDofs(), 2));
  EXPECT_EQ(ledger.counted("back-solves"), 5);
  condensed->applySchur(Vector(std::size_t(n), 0.0));
  neumann().solveNeumann(Vector(std::size_t(n), 0.0));
  const bool isDirect = condensed->hasCheapSchur(); // the block of the kept dofs is enough
  EXPECT_EQ(ledger.counted("back-solves"), isDirect ? 5 : 7);
  EXPECT_EQ(ledger.counted("kept solves"), isDirect ? 2 : 0);
  condensed->schurComplement();
  EXPECT_EQ(ledger.counted("back-solves"), isDirect ? 5 : 7 + n);
}

TEST_P(EverySolver, NeumannSolutionVanishesAtTheHeldDofsAndMeetsTheOtherEquations)
{
  ASSERT_TRUE(neumann().solvesNeumann());
  const Vector force = keptValues(7), u = neumann().solveNeumann(force);
  Vector reached = multiply(reference.schur, u), wanted = force;
  for (const int held : neumann().freeMotions().held) {
    EXPECT_EQ(u[std::size_t(held)], 0.0);
    reached[std::size_t(held)] = wanted[std::size_t(held)] = 0.0;
  }
  EXPECT_LT(test::relativeDifference(reached, wanted), 100.0 * tolerance());
}

TEST_P(EverySolver, ForcesThatBalanceTheFreeMotionsNeedNoReaction)
{
  const Vector force = multiply(reference.schur, keptValues(8)); // of a displacement, so in balance
  EXPECT_LT(test::relativeDifference(multiply(reference.schur, neumann().solveNeumann(force)), force),
            100.0 * tolerance());
}

TEST_P(EverySolver, FreeMotionsNeedNoForce)
{
  const FreeMotions& motions = neumann().freeMotions();
  const int rigid = GetParam().cells.size() == 2 ? 3 : 6;
  const std::map<test::Support, int> count = {
      {test::Support::None, rigid}, {test::Support::Guide, 1}, {test::Support::Clamp, 0}};
  EXPECT_EQ(motions.traces.cols(), count.at(GetParam().support));
  EXPECT_EQ(int(motions.held.size()), motions.traces.cols());
  for (int m = 0; m < motions.traces.cols(); ++m)
    EXPECT_LT(norm(multiply(reference.schur, motions.traces.column(m))),
              1e-10 * norm(reference.schur.column(0)) * norm(motions.traces.column(m)));
}

TEST_P(EverySolver, RefusesLoadsOfTheWrongShape)
{
  EXPECT_THROW(condensed->expand(DenseMatrix(3, 1), DenseMatrix(int(problem.kept.size()), 1)), InternalError);
  EXPECT_THROW(condensed->expand(DenseMatrix(body.matrix.numDofs(), 2), DenseMatrix(int(problem.kept.size()), 1)),
               InternalError);
  EXPECT_THROW(condensed->reduce(DenseMatrix(3, 1)), InternalError);
}

constexpr double roundOff = 1e-11, krylovTolerance = 1e-7;

INSTANTIATE_TEST_SUITE_P(AllSolvers, EverySolver,
                         testing::Values(Case{"Cholmod", {12, 9}, test::Support::Clamp, roundOff},
                                         Case{"Cholmod", {3, 2, 3}, test::Support::None, roundOff},
                                         Case{"Mumps", {12, 9}, test::Support::Clamp, roundOff},
                                         Case{"Mumps", {3, 2, 3}, test::Support::None, roundOff},
                                         Case{"Krylov", {12, 9}, test::Support::Clamp, krylovTolerance},
                                         Case{"Krylov", {3, 2, 3}, test::Support::None, krylovTolerance},
                                         Case{"Multigrid", {12, 8}, test::Support::Clamp, krylovTolerance},
                                         Case{"Multigrid", {4, 2, 4}, test::Support::None, krylovTolerance},
                                         Case{"Automatic", {7, 5}, test::Support::Guide, roundOff}),
                         [](const auto& oneCase) {
                           return std::string(oneCase.param.solver) +
                                  (oneCase.param.cells.size() == 2 ? "In2D" : "In3D");
                         });

} // namespace ndframe
