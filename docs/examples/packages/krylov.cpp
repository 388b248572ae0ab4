// Chooses the linear solver Krylov as a deck's list does, which loads the module krylov, and solves a row of springs by
// conjugate gradients with a preconditioner of Ifpack2.
#include <cmath>

#include "ndframe/iterative/linear_solvers.hpp"

using namespace ndframe;

/// Nodes in a row, springs of stiffness 1 between neighbours and from both ends to a wall.
BlockMatrix springRow(int nodes)
{
  BlockMatrix K{1, IndexMap::whole(nodes), {0}, {}, {}};
  for (int node = 0; node < nodes; ++node) {
    for (int other = std::max(node - 1, 0); other <= std::min(node + 1, nodes - 1); ++other) {
      K.cols.push_back(other);
      K.values.push_back(other == node ? 2.0 : -1.0);
    }
    K.rowPtr.push_back(K.numBlocks());
  }
  return K;
}

int main()
{
  Registry<LinearSolver> solvers("linear solver", "Automatic");
  registerLinearSolvers(solvers);
  const BlockMatrix K = springRow(10);
  SolverProblem problem;
  problem.matrix = &K;
  problem.roles.assign(10, DofRole::Interior);
  Ledger ledger; // counts what the solver does
  const Vector u = solvers.build({"Type=Krylov", "Tolerance=1e-13", "Preconditioner/Type=Ifpack2"})
                       ->factor(problem, Comm::single(), ledger)
                       ->expand(DenseMatrix(Vector(10, 1.0)), DenseMatrix(0, 1))
                       .column(0);
  bool ok = ledger.counted("Krylov iterations") > 0;
  for (int node = 0; node < 10; ++node) // the deflection is a parabola
    ok = ok && std::abs(u[std::size_t(node)] - 0.5 * (node + 1) * (10 - node)) < 1e-11;
  finishMpi(); // the module has started MPI; what it made must be gone
  return ok ? 0 : 1;
}
