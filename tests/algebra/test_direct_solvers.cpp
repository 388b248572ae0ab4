#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"

namespace ndframe
{

namespace
{

class DirectSolver : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    if (test::comm().size() > 1 && std::string(GetParam()) == "Cholmod")
      GTEST_SKIP() << "Cholmod runs on one rank";
  }

  std::unique_ptr<CondensedBody> factor(const SolverProblem& problem)
  {
    return test::makeSolver(GetParam())->factor(problem, test::comm(), ledger);
  }

  /// The dof that SingularBody names; fails when nothing is thrown.
  int singularDof(const SolverProblem& problem)
  {
    try {
      factor(problem);
    } catch (const SingularBody& singular) {
      EXPECT_THAT(singular.what(), testing::HasSubstr("not positive definite"));
      return singular.dof;
    }
    ADD_FAILURE() << "the body was factored";
    return -2;
  }

  Ledger ledger;
};

/// A chain of springs between neighbours, scalar unknowns.
test::SampleBody chain(int springs)
{
  return test::trussBody({springs}, test::comm());
}

DenseMatrix schurOf(const std::vector<int>& cells, test::Support support, double stiffness, double length,
                    const std::string& solver)
{
  const test::SampleBody body = test::trussBody(cells, test::comm(), stiffness, length);
  const SolverProblem problem = body.problem(support);
  Ledger ledger;
  return test::makeSolver(solver)->factor(problem, test::comm(), ledger)->schurComplement();
}

} // namespace

TEST_P(DirectSolver, RigidMotionsOfAFloatingBodyAreInTheNullSpaceOfItsSchurComplement)
{
  const test::SampleBody body = test::trussBody({60, 40}, test::comm());
  const SolverProblem problem = body.problem(test::Support::None);
  const DenseMatrix S = factor(problem)->schurComplement();
  for (int m = 0; m < body.rigidMotions.cols(); ++m) {
    Vector normal;
    for (const int dof : problem.kept)
      normal.push_back(body.rigidMotions(dof, m));
    EXPECT_LT(norm(multiplySymmetric(S, normal)), 1e-12 * S(0, 0) * norm(normal)) << "motion " << m;
  }
}

TEST_P(DirectSolver, SchurComplementScalesWithTheUnits)
{
  const DenseMatrix S = schurOf({6, 4}, test::Support::None, 1.0, 1.0, GetParam());
  for (const double stiffness : {1e-12, 1e11})
    for (const double length : {1e-6, 1e3}) {
      DenseMatrix other = schurOf({6, 4}, test::Support::None, stiffness, length, GetParam());
      for (int j = 0; j < S.cols(); ++j)
        for (int i = 0; i < S.rows(); ++i)
          other(i, j) /= stiffness;
      EXPECT_LT(test::relativeDifference(other, S), 1e-12);
    }
}

TEST_P(DirectSolver, WithoutKeptDofsExpandIsThePlainSolution)
{
  const test::SampleBody body = test::trussBody({8, 6}, test::comm());
  const SolverProblem problem = body.problemWithoutKept(test::Support::Clamp);
  const auto condensed = factor(problem);
  Vector u = test::randomVector(problem.roles.size(), 1);
  for (std::size_t dof = 0; dof < u.size(); ++dof)
    if (problem.roles[dof] == DofRole::Fixed)
      u[dof] = 0.0;
  const Vector load = multiply(body.matrix, u, test::comm());
  EXPECT_LT(test::relativeDifference(condensed->expand(DenseMatrix(load), DenseMatrix(0, 1)).column(0), u), 1e-12);
  EXPECT_EQ(condensed->schurComplement().rows(), 0);
  EXPECT_EQ(condensed->reduce(DenseMatrix(load)).rows(), 0);
}

/// Kept dofs that cut the interior into parts, some of which touch late kept dofs only.
TEST_P(DirectSolver, InteriorInSeveralPartsGivesTheSameSchurComplement)
{
  const test::SampleBody body = chain(60), whole = test::trussBody({60}, Comm::single());
  const std::vector<std::vector<int>> orders = {{10, 40, 50}, {50, 10, 40}, {50, 40, 10}, {40, 50, 10}};
  for (const auto& kept : orders) {
    const auto condensed = factor(test::problemWith(body.matrix, kept, {}));
    const test::DenseReference reference(test::problemWith(whole.matrix, kept, {}));
    EXPECT_LT(test::relativeDifference(condensed->schurComplement(), reference.schur), 1e-12);
    const Vector load = test::randomVector(61, 1), values = {1.0, -2.0, 0.5};
    EXPECT_LT(test::relativeDifference(condensed->expand(DenseMatrix(load), DenseMatrix(values)).column(0),
                                       reference.expand(load, values)),
              1e-12);
    EXPECT_LT(test::relativeDifference(condensed->reduce(DenseMatrix(load)).column(0), reference.reduce(load)), 1e-12);
  }
}

TEST_P(DirectSolver, PivotsTellOfAFloatingInteriorWhenNoMotionsAreGiven)
{
  const test::SampleBody body = test::trussBody({30, 20}, test::comm());
  const bool namesDofs = std::string(GetParam()) == "Cholmod";
  SolverProblem problem = body.problemWithoutKept(test::Support::None);
  problem.nearNullSpace = {};
  EXPECT_EQ(singularDof(problem) >= 0, namesDofs);
  problem = body.problemWithoutKept(test::Support::Guide);
  problem.nearNullSpace = {};
  EXPECT_EQ(singularDof(problem) % 2, namesDofs ? 1 : -1) << "the body may move along the second axis";
}

TEST_P(DirectSolver, PivotsTellOfAMatrixThatIsNotPositiveDefinite)
{
  test::SampleBody body = chain(20);
  for (std::size_t r = 0; r < std::size_t(body.matrix.numRows()); ++r)
    if (body.matrix.rowNode(int(r)) == 7)
      *body.matrix.block(int(r), int(r)) = -1.0;
  singularDof(test::problemWith(body.matrix, {0}, {20}));
}

TEST_P(DirectSolver, ASlenderBodyIsNotTakenForASingularOne)
{
  const test::SampleBody body = test::trussBody({1, 400}, test::comm());
  EXPECT_NO_THROW(factor(body.problem(test::Support::Clamp)));
  EXPECT_NO_THROW(factor(body.problemWithoutKept(test::Support::Clamp)));
}

TEST_P(DirectSolver, CountsOneFactorisationAndTimesItsTwoStages)
{
  const test::SampleBody body = test::trussBody({8, 6}, test::comm());
  const auto condensed = factor(body.problem(test::Support::None));
  condensed->schurComplement();
  EXPECT_EQ(ledger.counted("factorisations"), 1);
  EXPECT_GT(ledger.counted("factor nonzeros"), 126); // at least one for each of the 126 dofs
  std::vector<std::string> stages;
  for (const auto& stage : ledger.stages())
    stages.push_back(stage.name);
  EXPECT_THAT(stages, testing::ElementsAre("order", "factor"));
  EXPECT_TRUE(condensed->hasCheapSchur());
  EXPECT_THAT(condensed->description(), testing::HasSubstr("METIS nested dissection"));
}

INSTANTIATE_TEST_SUITE_P(Solvers, DirectSolver, testing::Values("Cholmod", "Mumps"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST(Cholmod, WithoutInteriorDofsTheSchurComplementIsTheMatrix)
{
  const test::SampleBody body = test::trussBody({3}, Comm::single());
  Ledger ledger;
  const DenseMatrix S = test::makeSolver("Cholmod")
                            ->factor(test::problemWith(body.matrix, {3, 1, 0, 2}, {}), Comm::single(), ledger)
                            ->schurComplement();
  const Vector column = multiply(body.matrix, {0.0, 1.0, 0.0, 0.0}, Comm::single());
  EXPECT_LT(test::relativeDifference(S.column(1), {column[3], column[1], column[0], column[2]}), 1e-14);
}

TEST(Mumps, WithoutInteriorDofsSaysWhatToDo)
{
  const test::SampleBody body = chain(3);
  Ledger ledger;
  EXPECT_THROW(
      test::makeSolver("Mumps")->factor(test::problemWith(body.matrix, {3, 1, 0, 2}, {}), test::comm(), ledger),
      InputError);
}

TEST(Cholmod, StartsNoThreads)
{
  namespace fs = std::filesystem;
  const auto threads = [] {
    std::set<std::string> names;
    for (const auto& thread : fs::directory_iterator("/proc/self/task"))
      names.insert(thread.path().filename());
    return names;
  };
  const test::SampleBody body = test::trussBody({20, 20}, Comm::single());
  const auto before = threads();
  Ledger ledger;
  test::makeSolver("Cholmod")->factor(body.problem(test::Support::Clamp), Comm::single(), ledger);
  for (const std::string& thread : threads()) // MPI's own may end meanwhile
    EXPECT_EQ(before.count(thread), 1U) << thread;
}

TEST(Cholmod, RunsOnOneRankOnly)
{
  if (test::comm().size() == 1)
    GTEST_SKIP() << "needs several ranks";
  const test::SampleBody body = chain(5);
  Ledger ledger;
  try {
    test::makeSolver("Cholmod")->factor(test::problemWith(body.matrix, {}, {0}), test::comm(), ledger);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("Cholmod runs on one rank; use Mumps or Krylov (or Automatic)"));
  }
}

} // namespace ndframe
