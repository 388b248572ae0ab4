#pragma once

#include <string>
#include <vector>

#include "certificate/sweep_options.hpp"

namespace ndframe::test
{

/// One way of bounding the error, and how sharp it must be: bound / error over all scenes of its group.
struct Variant
{
  std::string name, recovery, traction;
  int degree = 2, sweeps = 0;
  bool stretched = false;               ///< on meshes of aspect 5 instead of 1
  double median = 1e300, worst = 1e300; ///< limits
};

/// The bound of one variant on one scene.
struct Sharpness
{
  int scene = 0;
  std::string kind, variant;
  double bound = 0.0, elements = 0.0, contact = 0.0, projection = 0.0, oscillation = 0.0;
  double error = 0.0;     ///< extrapolated
  double reference = 0.0; ///< that of the finest reference: a little less
  int refinements = 0;
  double meanStress = 0.0; ///< effectivity of the bound of the mean stress
  double effectivity() const { return bound / error; }
};

/// Effectivities of all variants over converged P2 scenes (drawIsotropicScene) against extrapolated references: prints
/// a table, writes sharpness.csv. Returns whether every limit holds.
bool measureSharpness(const SweepOptions& options);

/// The limit of errors against references with cells h/2^k, h/2^(k+1), h/2^(k+2), all from below: Aitken's
/// extrapolation of their squares, which converge geometrically with the energies of the references. Squares that do
/// not: the last error.
double extrapolatedError(double first, double second, double third);

/// Is bound below error, or are the median and the largest effectivity of this variant above its limits? One sentence
/// each.
std::vector<std::string> judgeSharpness(const Variant& variant, const std::vector<Sharpness>& all);

} // namespace ndframe::test
