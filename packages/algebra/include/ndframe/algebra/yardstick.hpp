#pragma once

#include <cstdint>

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// Seconds on the wall and of the processor (all threads of the process).
struct Seconds
{
  double wall = 0.0, /**< elapsed */ processor = 0.0; ///< of all threads of the process

  Seconds& operator+=(const Seconds& other); ///< adds both
};

/// What the libraries alone need for a body.
struct Yardstick
{
  std::int64_t dofs = 0;                                                         ///< free ones
  std::int64_t nonzeros = 0;                                                     ///< of the factor, one triangle
  double flops = 0.0;                                                            ///< of the factorisation
  Seconds order, /**< METIS */ factor, /**< analysis and factorisation */ solve; ///< one right-hand side

  Seconds total() const;                         ///< order, factor and solve
  Yardstick& operator+=(const Yardstick& other); ///< adds all, as of another body
};

/// Times METIS's ordering of the graph of all nodes with free dofs, CHOLMOD's analysis and factorisation of the free
/// matrix, and one solve with it for `load` (numDofs). Kept dofs are eliminated like all others; their diagonal gets
/// the shift of a run's factor, which makes the matrix of a floating body regular. Building the libraries' inputs is
/// not timed, and nothing is checked. One rank.
Yardstick measureYardstick(const SolverProblem& problem, const Vector& load);

} // namespace ndframe
