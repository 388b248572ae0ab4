#pragma once

#include "admissibility/sample_problems.hpp"
#include "equilibrium/sample_stress.hpp"

namespace ndframe::test
{

/// A solution of the equations of elasticity, given by functions of the position.
struct ExactSolution
{
  int dim = 0;
  StressField stress;                                           ///< K eps(u), Voigt
  std::vector<SampledFunction> stressFunctions, forceFunctions; ///< the same as expressions, and - div of it
};

/// A function of the position that is finite everywhere.
SampledFunction functionOf(const std::string& text);

/// u_i = x sum_m a_im sin(k_m . x + phase_im): not a polynomial, zero on x = 0. waves: times 2 pi over the unit length.
ExactSolution waveSolution(const Elasticity& law, double waves, unsigned seed);

/// The body clamped on its side "left" (x = 0) under the loads that make `exact` its solution, solved.
Problem solvedUnder(const ExactSolution& exact, Mesh mesh, int order, int degree, const Elasticity& law);

/// Squared distances in the complementary energy norm, by quadrature. sigma_h = K eps(u_h), sigma^ = sigma_h + c.
struct Distances
{
  double computed = 0.0;     ///< |sigma - sigma_h|^2 = |u - u_h|^2
  double equilibrated = 0.0; ///< |sigma - sigma^|^2
  double mean = 0.0;         ///< |sigma - (sigma^ + sigma_h) / 2|^2
};

Distances distances(const ExactSolution& exact, const Problem& problem, const StressCorrection& correction);

} // namespace ndframe::test
