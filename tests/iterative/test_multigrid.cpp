#include <array>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"

namespace ndframe
{

namespace
{

std::string number(const std::string& name, const std::string& type, const std::string& value)
{
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

struct Solved
{
  Vector u;
  double residual; ///< of the interior equations, relative to the load
  int iterations;
};

Solved solve(const test::SampleBody& body, const SolverProblem& problem, const std::string& xml, Ledger& ledger)
{
  const auto condensed = test::makeSolver("Multigrid", xml)->factor(problem, test::comm(), ledger);
  const Vector load = test::randomVector(problem.roles.size(), 1);
  const auto before = ledger.counted("Krylov iterations");
  Solved result{condensed->expand(DenseMatrix(load), DenseMatrix(int(problem.kept.size()), 1)).column(0), 0.0, 0};
  result.iterations = int(ledger.counted("Krylov iterations") - before);
  const Vector force = multiply(body.matrix, result.u, test::comm());
  Vector residual, given;
  for (std::size_t dof = 0; dof < load.size(); ++dof)
    if (problem.roles[dof] == DofRole::Interior) {
      residual.push_back(load[dof] - force[dof]);
      given.push_back(load[dof]);
    }
  result.residual = norm(residual) / norm(given);
  return result;
}

Solved solve(const test::SampleBody& body, const SolverProblem& problem, const std::string& xml = {})
{
  Ledger ledger;
  return solve(body, problem, xml, ledger);
}

} // namespace

TEST(Multigrid, ReachesTheToleranceAndNoMore)
{
  const test::SampleBody body = test::trussBody({12, 12, 8}, test::comm());
  const SolverProblem problem = body.problem(test::Support::Guide);
  EXPECT_LE(solve(body, problem).residual, 1e-10);
  EXPECT_LE(solve(body, problem, number("Tolerance", "double", "1e-13")).residual, 1e-13);
  EXPECT_GT(solve(body, problem, number("Tolerance", "double", "1e-3")).residual, 1e-8);
}

TEST(Multigrid, NeedsHardlyMoreIterationsOnFinerMeshes)
{
  const test::SampleBody coarse = test::trussBody({8, 8, 8}, test::comm());
  const test::SampleBody fine = test::trussBody({16, 16, 16}, test::comm());
  const int few = solve(coarse, coarse.problem(test::Support::Clamp)).iterations;
  EXPECT_LE(solve(fine, fine.problem(test::Support::Clamp)).iterations, 1.5 * few);
  EXPECT_LE(few, 40);
}

TEST(Multigrid, DoesNotDependOnTheAxesOfNodesNorOnUnits)
{
  test::SampleBody body = test::trussBody({8, 8, 4}, test::comm());
  SolverProblem problem = body.problem(test::Support::None);
  const Solved plain = solve(body, problem);
  std::vector<int> chosen;
  for (int node = 0; node < body.matrix.numNodes(); node += 2)
    chosen.push_back(node);
  test::turnNodes(body, problem, chosen);
  EXPECT_NEAR(solve(body, problem).iterations, plain.iterations, 4);
  const test::SampleBody scaled = test::trussBody({8, 8, 4}, test::comm(), 3e9, 1e-3);
  const Solved inUnits = solve(scaled, scaled.problem(test::Support::None));
  EXPECT_NEAR(inUnits.iterations, plain.iterations, 1);
  Vector u = inUnits.u;
  for (double& value : u)
    value *= 3e9;
  EXPECT_LT(test::relativeDifference(u, plain.u), 1e-8);
}

TEST(Multigrid, CountsProductsCyclesAndSetUps)
{
  const test::SampleBody body = test::trussBody({8, 8, 4}, test::comm());
  const SolverProblem problem = body.problem(test::Support::Guide);
  Ledger ledger;
  const int iterations = solve(body, problem, "", ledger).iterations;
  EXPECT_EQ(ledger.counted("multigrid set-ups"), 1);
  EXPECT_EQ(ledger.counted("factorisations"), 0);
  const auto cycles = ledger.counted("multigrid cycles"), products = ledger.counted("fine products");
  EXPECT_EQ(cycles, iterations) << "none for a residual that is small enough";
  EXPECT_LE(products - 5 * cycles, 20 + 3) << "four products a cycle, one of conjugate gradients, none of zero";
}

namespace
{

/// Per rank what its rows need: ranks and nodes that others own, summed over all ranks.
std::array<std::int64_t, 2> neededBy(const BlockMatrix& K)
{
  const Comm comm = test::comm();
  Vector owner(std::size_t(K.numNodes()), 0.0);
  for (int r = 0; r < K.numRows(); ++r)
    owner[std::size_t(K.rowNode(r))] = comm.rank();
  comm.sum(owner);
  std::set<int> ranks;
  for (int ghost = K.numRows(); ghost < K.nodes.size(); ++ghost)
    ranks.insert(int(owner[std::size_t(K.nodes.global(ghost))]));
  return {comm.sum(std::int64_t(ranks.size())), comm.sum(std::int64_t(K.nodes.size() - K.numRows()))};
}

} // namespace

/// A product takes one message from each rank that owns nodes of its columns, with the numbers of these nodes; cycles
/// take more on the vertices. Products for residuals outside of conjugate gradients are summed up instead.
TEST(Multigrid, CountsWhatRanksSendToEachOther)
{
  const test::SampleBody body = test::trussBody({12, 8, 8}, test::comm());
  Ledger ledger, again;
  solve(body, body.problem(test::Support::Clamp), "", ledger);
  solve(body, body.problem(test::Support::Clamp), "", again);
  const auto messages = ledger.counted("halo messages"), bytes = ledger.counted("halo bytes");
  EXPECT_EQ(again.counted("halo messages"), messages);
  EXPECT_EQ(again.counted("halo bytes"), bytes);
  if (test::comm().size() == 1) {
    EXPECT_EQ(ledger.counts().count("halo messages"), 0u);
    EXPECT_EQ(ledger.counts().count("halo bytes"), 0u);
    return;
  }
  const auto products = ledger.counted("fine products"), cycles = ledger.counted("multigrid cycles");
  const auto [ranks, nodes] = neededBy(body.matrix);
  const std::int64_t residuals = 6, pairs = test::comm().size() * (test::comm().size() - 1);
  EXPECT_GE(messages, ranks * (products - residuals));
  EXPECT_LE(messages, ranks * products + pairs * cycles * (2 + 2 * 10 + 19)) << "transfers, levels, the coarsest one";
  EXPECT_GE(bytes, 24 * nodes * (products - residuals));
  EXPECT_LE(bytes, 24 * nodes * (products + 4 * cycles)) << "vertices are an eighth of the nodes";
}

TEST(Multigrid, TakesEveryNodeForAVertexWhereNoneIsOnAnEdge)
{
  const test::SampleBody body = test::trussBody({7, 5, 3}, test::comm());
  const SolverProblem problem = body.problem(test::Support::Clamp);
  ASSERT_TRUE(problem.edgeNodes.ends.empty());
  Ledger ledger;
  EXPECT_LE(solve(body, problem, "", ledger).residual, 1e-10);
  EXPECT_EQ(ledger.counted("multigrid cycles"), 0);
}

/// Two elements' worth of nodes, and a body whose vertices are all held.
TEST(Multigrid, SolvesTheSmallestBodies)
{
  const test::SampleBody body = test::trussBody({2, 2, 2}, test::comm());
  EXPECT_LE(solve(body, body.problem(test::Support::Clamp)).residual, 1e-10);
  SolverProblem held = body.problem(test::Support::Clamp);
  for (std::size_t node = 0; node < held.edgeNodes.ends.size(); ++node)
    for (std::size_t i = 0; i < 3; ++i)
      if (held.edgeNodes.ends[node][0] == held.edgeNodes.ends[node][1] && held.roles[3 * node + i] != DofRole::Kept)
        held.roles[3 * node + i] = DofRole::Fixed;
  EXPECT_LE(solve(body, held).residual, 1e-10);
}

TEST(Multigrid, TellsWhatItIs)
{
  const test::SampleBody body = test::trussBody({4, 4, 2}, test::comm());
  Ledger ledger;
  const auto condensed =
      test::makeSolver("Multigrid")->factor(body.problem(test::Support::Clamp), test::comm(), ledger);
  EXPECT_EQ(condensed->description(), "Multigrid, Belos CG, Chebyshev and on the vertices MueLu, tolerance 1e-10");
  EXPECT_FALSE(condensed->hasCheapSchur());
}

TEST(Multigrid, ChecksTheParametersOfTheLibraries)
{
  EXPECT_THAT(test::complaint("Multigrid", "<ParameterList name=\"MueLu\">" + number("coarse: max siz", "int", "9") +
                                               "</ParameterList>"),
              testing::HasSubstr("did you mean \"coarse: max size\"?"));
  EXPECT_THAT(test::complaint("Multigrid", number("Tolerance", "double", "0")), testing::HasSubstr("(0, 1)"));
  EXPECT_THAT(test::complaint("Multigrid", "<ParameterList name=\"Preconditioner\"/>"),
              testing::HasSubstr("Preconditioner"));
}

TEST(Multigrid, SaysHowFarItIsWhenTheIterationsRunOut)
{
  const test::SampleBody body = test::trussBody({8, 8, 4}, test::comm());
  try {
    solve(body, body.problem(test::Support::Clamp), number("Maximum Iterations", "int", "2"));
    FAIL();
  } catch (const std::exception& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("after 2 iterations"));
  }
}

} // namespace ndframe
