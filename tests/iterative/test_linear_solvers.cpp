#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/algebra/neumann_solver.hpp"
#include "solvers.hpp"

namespace ndframe
{

namespace
{

class AnySolver : public testing::TestWithParam<const char*>
{};

std::string singularityFound(const std::string& solver, const SolverProblem& problem)
{
  Ledger ledger;
  try {
    test::makeSolver(solver)->factor(problem, test::comm(), ledger);
    return "none";
  } catch (const SingularBody& singular) {
    EXPECT_GE(singular.dof, 0);
    return singular.what();
  }
}

} // namespace

TEST_P(AnySolver, RefusesABodyThatARigidMotionLeavesUnheld)
{
  const test::SampleBody body = test::trussBody({5, 4}, test::comm());
  EXPECT_THAT(singularityFound(GetParam(), body.problemWithoutKept(test::Support::None)),
              testing::HasSubstr("a rigid motion of the body moves none of its fixed or interface dofs"));
  EXPECT_THAT(singularityFound(GetParam(), body.problemWithoutKept(test::Support::Guide)),
              testing::HasSubstr("dof 1 moves most"));
  EXPECT_EQ(singularityFound(GetParam(), body.problem(test::Support::Guide)), "none");
}

TEST_P(AnySolver, IgnoresNearNullSpaceThatCostsEnergy)
{
  const test::SampleBody body = test::trussBody({5, 4}, test::comm());
  SolverProblem problem = body.problemWithoutKept(test::Support::Clamp);
  problem.nearNullSpace = DenseMatrix(body.matrix.numDofs(), 1);
  problem.nearNullSpace(body.matrix.numDofs() - 1, 0) = 1.0; // an unheld dof that its neighbours hold
  EXPECT_EQ(singularityFound(GetParam(), problem), "none");
}

TEST_P(AnySolver, RefusesABodyWithAllDofsFixed)
{
  const test::SampleBody body = test::trussBody({1, 1}, test::comm());
  Ledger ledger;
  EXPECT_THROW(test::makeSolver(GetParam())
                   ->factor(test::problemWith(body.matrix, {}, {0, 1, 2, 3, 4, 5, 6, 7}), test::comm(), ledger),
               InputError);
}

TEST_P(AnySolver, RefusesRolesThatDisagreeWithTheKeptDofs)
{
  const test::SampleBody body = test::trussBody({2, 2}, test::comm());
  Ledger ledger;
  SolverProblem problem = body.problem(test::Support::Clamp);
  problem.kept.pop_back();
  EXPECT_THROW(test::makeSolver(GetParam())->factor(problem, test::comm(), ledger), InternalError);
}

INSTANTIATE_TEST_SUITE_P(Solvers, AnySolver, testing::Values("Automatic", "Mumps", "Multigrid", "Krylov"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST(Automatic, IsCholmodOnOneRankAndMumpsOnSeveral)
{
  const test::SampleBody body = test::trussBody({3, 2}, test::comm());
  const SolverProblem problem = body.problem(test::Support::Clamp);
  Ledger ledger;
  EXPECT_THAT(test::makeSolver("Automatic")->factor(problem, test::comm(), ledger)->description(),
              testing::StartsWith(test::comm().size() == 1 ? "Cholmod" : "Mumps"));
}

TEST(Automatic, IsMultigridForLargeSolidsThatNeedNoSchurComplement)
{
  const auto solver = test::makeSolver("Automatic");
  const int ranks = test::comm().size();
  const std::string factored = ranks == 1 ? "Cholmod" : "Mumps";
  const BodyOutline large{3, 50000, 1, false, 0.3};
  const auto changed = [&](const auto& change) {
    BodyOutline outline = large;
    change(outline);
    return solver->name(outline, ranks);
  };
  EXPECT_EQ(solver->name(large, ranks), "Multigrid");
  EXPECT_EQ(changed([](BodyOutline& body) { body.dofs = 10000; }), factored);
  EXPECT_EQ(changed([](BodyOutline& body) { body.dim = 2; }), factored) << "in the plane factors are cheap";
  EXPECT_EQ(changed([](BodyOutline& body) { body.isCondensed = true; }), factored);
  EXPECT_EQ(changed([](BodyOutline& body) { body.poissonRatio = 0.49; }), factored);
  EXPECT_EQ(changed([](BodyOutline& body) { body.bodies = 2; }), factored) << "statuses take solves of their own";
  EXPECT_EQ(changed([](BodyOutline& body) { body.bodies = 2, body.dofs = 70000; }), "Multigrid");
  EXPECT_EQ(test::makeSolver("Cholmod")->name(large, ranks), "Cholmod");
}

TEST(Automatic, HasASecondChoiceWhereTheFirstFails)
{
  const test::SampleBody body = test::trussBody({8, 8, 4}, test::comm());
  const SolverProblem problem = body.problem(test::Support::Clamp);
  const char* few = "<Parameter name=\"Maximum Iterations\" type=\"int\" value=\"2\"/>";
  Ledger ledger;
  const auto solver = makeWithSecondChoice(test::makeSolver("Multigrid", few), test::makeSolver("Mumps"));
  const auto condensed = solver->factor(problem, test::comm(), ledger);
  EXPECT_THAT(condensed->description(), testing::StartsWith("Multigrid"));
  const DenseMatrix load(test::randomVector(problem.roles.size(), 1)), kept(int(problem.kept.size()), 1);
  const Vector u = condensed->expand(load, kept).column(0);
  const auto direct = test::makeSolver("Mumps")->factor(problem, test::comm(), ledger);
  EXPECT_LT(test::relativeDifference(u, direct->expand(load, kept).column(0)), 1e-12);
  EXPECT_THAT(condensed->description(), testing::StartsWith("Mumps"));
  // not the same bits: Mumps adds what ranks send in the order in which it comes
  EXPECT_LT(test::relativeDifference(u, condensed->expand(load, kept).column(0)), 1e-12);
  EXPECT_EQ(ledger.counted("solvers given up"), 1);
  EXPECT_EQ(neumannSolver(*condensed).solvesNeumann(), neumannSolver(*direct).solvesNeumann());
}

TEST(LinearSolvers, UnknownTypeIsAnsweredWithTheKnownOnes)
{
  const std::string text = test::complaint("Pardiso", "");
  for (const char* name : {"Automatic", "Cholmod", "Mumps", "Multigrid", "Krylov"})
    EXPECT_THAT(text, testing::HasSubstr(name));
}

TEST(LinearSolvers, AnswerOfSeveralRanksIsThatOfOne)
{
  const test::SampleBody own = test::trussBody({10, 6}, test::comm()), whole = test::trussBody({10, 6}, Comm::single());
  const SolverProblem distributed = own.problem(test::Support::Guide), alone = whole.problem(test::Support::Guide);
  Ledger ledger;
  const DenseMatrix S = test::makeSolver("Cholmod")->factor(alone, Comm::single(), ledger)->schurComplement();
  EXPECT_LT(test::relativeDifference(
                test::makeSolver("Mumps")->factor(distributed, test::comm(), ledger)->schurComplement(), S),
            1e-12);
  for (const char* iterative : {"Krylov", "Multigrid"})
    EXPECT_LT(test::relativeDifference(
                  test::makeSolver(iterative)->factor(distributed, test::comm(), ledger)->schurComplement(), S),
              1e-8)
        << iterative;
}

} // namespace ndframe
