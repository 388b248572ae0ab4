// Presses a string of springs against an obstacle: a contact problem of one body, solved by the status method.
#include <cmath>

#include "ndframe/subdomain/unilateral_problem.hpp"

int main()
{
  using namespace ndframe;
  // Three nodes in a row, held at both ends of the string: 2 u_i - u_{i-1} - u_{i+1} = load + contact force.
  const int size = 3;
  DenseMatrix stiffness(size, size);
  for (int i = 0; i < size; ++i) {
    stiffness(i, i) = 2.0;
    if (i > 0)
      stiffness(i, i - 1) = stiffness(i - 1, i) = -1.0;
  }
  const auto A = makeDenseOperator(stiffness);
  Ledger ledger;
  UnilateralProblem problem(*A, {1, 1, 1}, DenseMatrix(size, 0), {}, ledger); // no motion is free: the ends hold it

  // Without the obstacle the string would move by (1.5, 2, 1.5), so only the middle reaches it.
  const Vector load(size, 1.0), distance{1.2, 1.0, 1.2};
  const UnilateralState state = problem.solve(load, distance, {1, 1, 1});
  bool ok = state.closed == std::vector<char>{0, 1, 0};
  const Vector force{0.0, -1.0, 0.0};
  for (std::size_t i = 0; i < size; ++i)
    ok = ok && std::abs(state.u[i] - 1.0) < 1e-14 && std::abs(state.force[i] - force[i]) < 1e-14;
  return ok ? 0 : 1;
}
