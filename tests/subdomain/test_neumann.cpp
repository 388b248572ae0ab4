#include <algorithm>

#include <gtest/gtest.h>

#include "ndframe/subdomain/neumann_problem.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

DenseMatrix held(int size)
{
  return DenseMatrix(size, 0);
}

/// Takes the mean and the slope away, so that beams and chains are in balance.
Vector balanced(Vector force, int modes)
{
  const DenseMatrix R = rigidMotions(int(force.size()), modes);
  const Vector part = multiply(R, multiply(pseudoInverse(R, 1e-9), force));
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] -= part[i];
  return force;
}

} // namespace

TEST(NeumannProblem, ContactForceActsWithTheOppositeSign)
{
  // One spring of stiffness 2 along n_c, no load: compression (r < 0) pushes the Neumann body along n_c.
  Ledger ledger;
  const auto S = makeDenseOperator(DenseMatrix(Vector{2.0}));
  EXPECT_NEAR(NeumannProblem(*S, {0.0}, held(1), ledger).solve({-3.0})[0], 1.5, 1e-15);
  EXPECT_NEAR(NeumannProblem(*S, {1.0}, held(1), ledger).solve({-3.0})[0], 2.0, 1e-15);
}

TEST(NeumannProblem, FulfilsItsEquation)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Ledger ledger;
    const DenseMatrix S = randomSpd(10, seed);
    const auto op = makeDenseOperator(S);
    const Vector g = randomNumbers(10, seed + 1), r = randomNumbers(10, seed + 2);
    const Vector Su = multiply(S, NeumannProblem(*op, g, held(10), ledger).solve(r));
    for (std::size_t i = 0; i < g.size(); ++i)
      EXPECT_NEAR(Su[i] + r[i], g[i], 1e-11);
  }
}

TEST(NeumannProblem, IsFactoredOnce)
{
  Ledger ledger;
  const auto S = makeDenseOperator(randomSpd(5, 1));
  const NeumannProblem neumann(*S, Vector(5, 1.0), held(5), ledger);
  for (unsigned seed = 0; seed < 7; ++seed)
    neumann.solve(randomNumbers(5, seed));
  EXPECT_EQ(ledger.counted("interface factorisations"), 1);
  EXPECT_EQ(ledger.counted("Neumann solves"), 7);
}

TEST(NeumannProblem, FulfilsItsEquationWhenTheBodyFloatsAndTheForcesBalance)
{
  for (int modes = 1; modes <= 2; ++modes)
    for (unsigned seed = 0; seed < 20; ++seed) {
      Ledger ledger;
      const DenseMatrix S = modes == 1 ? floatingChain(9) : floatingBeam(9);
      const auto op = makeDenseOperator(S);
      const Vector g = balanced(randomNumbers(9, seed), modes), r = balanced(randomNumbers(9, seed + 1), modes);
      const Vector Su = multiply(S, NeumannProblem(*op, g, rigidMotions(9, modes), ledger).solve(r));
      for (std::size_t i = 0; i < g.size(); ++i)
        EXPECT_NEAR(Su[i] + r[i], g[i], 1e-11);
    }
}

TEST(HeldEntries, AreAsManyAsMotionsAndStopThem)
{
  for (int modes = 0; modes <= 2; ++modes) {
    const DenseMatrix R = rigidMotions(6, modes);
    const auto isFree = freeWhenHeld(R);
    EXPECT_EQ(std::count(isFree.begin(), isFree.end(), char(0)), modes);
    DenseMatrix atHeld(6, modes);
    for (int i = 0; i < 6; ++i)
      for (int m = 0; m < modes && !isFree[std::size_t(i)]; ++m)
        atHeld(i, m) = R(i, m);
    EXPECT_EQ(nullSpace(atHeld, 1e-9).cols(), 0);
  }
}

TEST(HeldEntries, AreNoneForMotionsWithoutTrace)
{
  EXPECT_EQ(freeWhenHeld(DenseMatrix(3, 1)), (std::vector<char>{1, 1, 1}));
}
