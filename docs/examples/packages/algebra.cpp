// Factors a chain of springs with the direct solver Cholmod and keeps its free end: what is left is one spring.
#include <cmath>

#include "ndframe/algebra/direct_solvers.hpp"

int main()
{
  using namespace ndframe;
  constexpr int springs = 10; // of stiffness 1, between the nodes 0 to 10
  BlockMatrix K;
  K.dim = 1;
  K.nodes = IndexMap::whole(springs + 1); // one process has all rows
  K.rowPtr = {0};
  for (int node = 0; node <= springs; ++node) {
    for (int other = std::max(node - 1, 0); other <= std::min(node + 1, springs); ++other) {
      K.cols.push_back(other);
      K.values.push_back(other != node ? -1.0 : node == 0 || node == springs ? 1.0 : 2.0);
    }
    K.rowPtr.push_back(K.numBlocks());
  }
  SolverProblem problem;
  problem.matrix = &K;
  problem.roles.assign(springs + 1, DofRole::Interior);
  problem.roles[0] = DofRole::Fixed;
  problem.roles[springs] = DofRole::Kept;
  problem.kept = {springs};

  Ledger ledger; // counts what the solver does
  const auto body = makeCholmod()->factor(problem, Comm::single(), ledger);
  const double stiffness = body->schurComplement()(0, 0);
  const DenseMatrix noLoad(K.numDofs(), 1), pulled(Vector{1.0});
  const Vector force = multiply(K, body->expand(noLoad, pulled).column(0), Comm::single());
  bool ok = std::abs(stiffness - 1.0 / springs) < 1e-14 && ledger.counted("factorisations") == 1;
  for (int node = 1; node < springs; ++node)
    ok = ok && std::abs(force[std::size_t(node)]) < 1e-14; // nothing pulls at the nodes between
  return ok && std::abs(force[springs] - stiffness) < 1e-14 ? 0 : 1;
}
