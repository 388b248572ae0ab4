// Asks which linear solver a body gets unless its deck names one, and solves a plane grid of springs by multigrid.
#include <cmath>

#include "ndframe/iterative/linear_solvers.hpp"

using namespace ndframe;

/// What a deck's list "Linear Solver" makes of this entry.
std::unique_ptr<LinearSolver> makeSolver(const std::string& type)
{
  Registry<LinearSolver> solvers("linear solver", "Automatic");
  registerLinearSolvers(solvers);
  return solvers.build({"Type=" + type});
}

/// n x n nodes, springs of stiffness 1 from each to its four neighbours, or to a wall.
BlockMatrix springGrid(int n)
{
  BlockMatrix K{1, IndexMap::whole(n * n), {0}, {}, {}};
  for (int node = 0; node < n * n; ++node) {
    const int i = node % n, j = node / n;
    const std::pair<bool, int> row[] = {{j > 0, -n}, {i > 0, -1}, {true, 0}, {i < n - 1, 1}, {j < n - 1, n}};
    for (const auto& [isThere, offset] : row)
      if (isThere) {
        K.cols.push_back(node + offset);
        K.values.push_back(offset == 0 ? 4.0 : -1.0);
      }
    K.rowPtr.push_back(K.numBlocks());
  }
  return K;
}

int main()
{
  const BodyOutline solid{3, 1000000, 1, false, 0.3}, plane{2, 1000000, 1, false, 0.3};
  bool ok =
      makeSolver("Automatic")->name(solid, 1) == "Multigrid" && makeSolver("Automatic")->name(plane, 1) == "Cholmod";

  constexpr int n = 63;
  const BlockMatrix K = springGrid(n);
  const auto parabola = [](int i) { return 0.5 * (i + 1) * (n - i); }; // its second difference is -1
  Vector load;
  for (int node = 0; node < n * n; ++node)
    load.push_back(parabola(node % n) + parabola(node / n));
  SolverProblem problem;
  problem.matrix = &K;
  problem.roles.assign(n * n, DofRole::Interior);
  Ledger ledger; // counts what the solver does
  const Vector u = makeSolver("Multigrid")
                       ->factor(problem, Comm::single(), ledger)
                       ->expand(DenseMatrix(load), DenseMatrix(0, 1))
                       .column(0);
  for (int node = 0; node < n * n; ++node) {
    const double exact = parabola(node % n) * parabola(node / n);
    ok = ok && std::abs(u[std::size_t(node)] - exact) < 1e-8 * exact;
  }
  finishMpi(); // the solver has started MPI; what it made must be gone
  return ok && ledger.counted("Krylov iterations") < 30 ? 0 : 1;
}
