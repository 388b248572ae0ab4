#include <gtest/gtest.h>

#include "ndframe/subdomain/neumann_problem.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

TEST(NeumannProblem, ContactForceActsWithTheOppositeSign)
{
  // One spring of stiffness 2 along n_c, no load: compression (r < 0) pushes the Neumann body along n_c.
  Ledger ledger;
  const auto S = makeDenseOperator(DenseMatrix(Vector{2.0}));
  EXPECT_NEAR(NeumannProblem(*S, {0.0}, ledger).solve({-3.0})[0], 1.5, 1e-15);
  EXPECT_NEAR(NeumannProblem(*S, {1.0}, ledger).solve({-3.0})[0], 2.0, 1e-15);
}

TEST(NeumannProblem, FulfilsItsEquation)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Ledger ledger;
    const DenseMatrix S = randomSpd(10, seed);
    const auto op = makeDenseOperator(S);
    const Vector g = randomNumbers(10, seed + 1), r = randomNumbers(10, seed + 2);
    const Vector Su = multiply(S, NeumannProblem(*op, g, ledger).solve(r));
    for (std::size_t i = 0; i < g.size(); ++i)
      EXPECT_NEAR(Su[i] + r[i], g[i], 1e-11);
  }
}

TEST(NeumannProblem, IsFactoredOnce)
{
  Ledger ledger;
  const auto S = makeDenseOperator(randomSpd(5, 1));
  const NeumannProblem neumann(*S, Vector(5, 1.0), ledger);
  for (unsigned seed = 0; seed < 7; ++seed)
    neumann.solve(randomNumbers(5, seed));
  EXPECT_EQ(ledger.counted("interface factorisations"), 1);
  EXPECT_EQ(ledger.counted("Neumann solves"), 7);
}
