#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_ParameterList.hpp>

#include "ndframe/algebra/linear_solver.hpp"
#include "preconditioner.hpp"

namespace ndframe
{

/// Preconditioned conjugate gradients of Belos on the interior problem of a body. All functions are collective.
class BelosCg
{
public:
  /// `list`: parameters of Belos's solver.
  BelosCg(const SolverProblem& problem, const Comm& comm, const Preconditioner& preconditioner,
          const Teuchos::ParameterList& list);
  ~BelosCg();

  struct Result
  {
    Vector x;       ///< replicated; round-off on fixed and kept dofs
    int iterations; ///< of this call
  };

  /// K_ii x_i = b_i from x = 0 until CG's own residual is below `tolerance` |b_i|, or maxIterations. `b` is replicated,
  /// zero outside the interior. Throws SingularBody when CG meets a direction without energy.
  Result solve(const Vector& b, double tolerance, int maxIterations) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The mistakes of a list of Belos parameters.
std::vector<std::string> belosMistakes(const Teuchos::ParameterList& list);

} // namespace ndframe
