#include <algorithm>

#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

constexpr unsigned manySeeds = 200;

} // namespace

TEST(Unilateral, AgreesWithTryingEveryClosedSet)
{
  for (int size = 1; size <= 8; ++size)
    for (unsigned seed = 0; seed < manySeeds / 4; ++seed) {
      SCOPED_TRACE(testing::Message() << "size " << size << ", seed " << seed);
      const auto problem = randomProblem(size, seed);
      expectSame(solve(problem), bruteForce(problem));
    }
}

TEST(Unilateral, FulfilsTheComplementarityConditionsToRoundOff)
{
  for (unsigned seed = 0; seed < manySeeds; ++seed) {
    const auto problem = randomProblem(40, seed);
    EXPECT_LT(kktDefect(problem, solve(problem)), 1e-10) << "seed " << seed;
  }
}

TEST(Unilateral, AnswerDoesNotDependOnTheFirstSet)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto problem = randomProblem(6, seed);
    const auto answer = solve(problem);
    for (int set = 0; set < 1 << 6; ++set) {
      auto start = problem.allClosed();
      for (std::size_t i = 0; i < start.size(); ++i)
        start[i] = start[i] && (set >> i & 1);
      expectSame(solve(problem, start), answer);
    }
  }
}

TEST(Unilateral, UnitsChangeNeitherStatusesNorPasses)
{
  const double stiffness = 1e9, length = 1e-3;
  for (unsigned seed = 0; seed < manySeeds; ++seed) {
    const auto problem = randomProblem(12, seed);
    auto scaled = problem;
    for (int i = 0; i < scaled.size() * scaled.size(); ++i)
      scaled.A.data()[i] *= stiffness;
    for (std::size_t i = 0; i < scaled.b.size(); ++i) {
      scaled.b[i] *= stiffness * length;
      scaled.bound[i] *= length;
    }
    const auto answer = solve(problem), inOtherUnits = solve(scaled);
    EXPECT_EQ(inOtherUnits.closed, answer.closed) << "seed " << seed;
    EXPECT_EQ(inOtherUnits.passes, answer.passes) << "seed " << seed;
    EXPECT_EQ(inOtherUnits.cycled, answer.cycled) << "seed " << seed;
  }
}

TEST(Unilateral, UnconstrainedEntriesNeverClose)
{
  // Two springs to the ground, both pressed far beyond their bounds; the second has none.
  SampleProblem problem{DenseMatrix(2, 2), {5.0, 5.0}, {1.0, 1.0}, {1, 0}, 0};
  problem.A(0, 0) = problem.A(1, 1) = 1.0;
  const auto state = solve(problem);
  EXPECT_EQ(state.closed, (std::vector<char>{1, 0}));
  EXPECT_EQ(state.u, (Vector{1.0, 5.0}));
  EXPECT_EQ(state.force, (Vector{-4.0, 0.0}));
}

TEST(Unilateral, CountsTheStatusesThatDifferFromTheStart)
{
  SampleProblem problem{DenseMatrix(3, 3), {5.0, -5.0, 0.5}, {1.0, 1.0, 1.0}, {1, 1, 1}, 0};
  for (int i = 0; i < 3; ++i)
    problem.A(i, i) = 1.0;
  EXPECT_EQ(solve(problem).changes, 2);
  EXPECT_EQ(solve(problem, {0, 0, 0}).changes, 1);
  EXPECT_EQ(solve(problem, {1, 0, 0}).changes, 0);
  EXPECT_EQ(solve(problem, {1, 0, 0}).passes, 1);
}

TEST(Unilateral, TouchingWithoutForceIsNotACase)
{
  // Both the force and the gap of the second node vanish: either status is right, and neither may flip for ever.
  for (const double noise : {0.0, 1e-16, -1e-16}) {
    SampleProblem problem{DenseMatrix(2, 2), {2.0, 1.0 + noise}, {1.0, 1.0}, {1, 1}, 0};
    problem.A(0, 0) = problem.A(1, 1) = 1.0;
    for (const char start : {char(0), char(1)}) {
      const auto state = solve(problem, {1, start});
      EXPECT_EQ(state.passes, 1);
      EXPECT_EQ(state.closed, (std::vector<char>{1, start}));
    }
  }
}

TEST(Unilateral, SetsThatComeBackAreReportedAndFinishedOneNodeAtATime)
{
  // Found by search: changing all statuses at once, the method comes back to a set it has seen.
  SampleProblem problem{DenseMatrix(4, 4), {-5.0, 5.0, 9.0, -6.0}, Vector(4, 0.0), std::vector<char>(4, 1), 0};
  const double entries[4][4] = {{23, -14, -9, 8}, {-14, 50, 47, -22}, {-9, 47, 51, -25}, {8, -22, -25, 16}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      problem.A(i, j) = entries[i][j];
  const auto state = solve(problem);
  EXPECT_TRUE(state.cycled);
  EXPECT_EQ(state.passes, 6);
  expectSame(state, bruteForce(problem));
  EXPECT_FALSE(solve(problem, state.closed).cycled);
}

TEST(Unilateral, FactorIsKeptWhileStatusesStay)
{
  Ledger ledger;
  const auto problem = randomProblem(8, 3);
  const auto A = makeDenseOperator(problem.A);
  UnilateralProblem unilateral(*A, problem.constrained, DenseMatrix(8, 0), {}, ledger);
  const auto first = unilateral.solve(problem.b, problem.bound, problem.allClosed());
  const auto factorisations = ledger.counted("interface factorisations");
  EXPECT_EQ(factorisations, first.passes);
  Vector doubled = problem.b, doubledBound = problem.bound;
  for (std::size_t i = 0; i < doubled.size(); ++i) {
    doubled[i] *= 2.0;
    doubledBound[i] *= 2.0;
  }
  const auto second = unilateral.solve(doubled, doubledBound, first.closed);
  EXPECT_EQ(ledger.counted("interface factorisations"), factorisations);
  EXPECT_EQ(ledger.counted("status passes"), first.passes + 1);
  EXPECT_EQ(second.changes, 0);
  for (std::size_t i = 0; i < doubled.size(); ++i)
    EXPECT_NEAR(second.u[i], 2.0 * first.u[i], 1e-12);
}
