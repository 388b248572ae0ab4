#pragma once

#include <optional>
#include <vector>

#include "data_enclosures.hpp"
#include "ndframe/sampling/sampling_rules.hpp"
#include "sampled_slab.hpp"

namespace ndframe
{

/// What functions are, to be shown by their enclosures, on a slab with one of the rules.
struct SampledLeaf
{
  SampledSlab slab;
  const SamplingRule* sampling = nullptr;
  double error = 0.0, normError = 0.0, slopeError = 0.0;
  bool isSettled = false;
  std::size_t worst = 0; ///< the function that misses most
  std::optional<AffineFunction> cut;
  DataSwitch curve; ///< where a function switches that is not affine
  /// Both sides of that curve, and what the share that may lie on the other side misses, in the mean and its square.
  std::vector<QuadratureRule> sides{};
  double openError = 0.0, openSquare = 0.0;
  bool areSidesFound = false;

  explicit SampledLeaf(SampledSlab where) : slab(std::move(where)) {}
  double weight() const { return isSettled ? 0.0 : slab.fraction() * error; }
  bool switchesAlongCurve() const { return !cut && curve.place >= 0; }
};

/// A slab with the first rule for which functions, as enclosed there, miss little enough.
SampledLeaf resolve(const SimplexGeometry& simplex, SampledSlab slab, double scale, DataEnclosures& data);

/// A triangle on which functions are settled but that they switch along a curve, with its sides if they are found;
/// nothing on others.
std::optional<SampledLeaf> settledOnSides(const SimplexGeometry& simplex, const SampledLeaf& leaf, double scale,
                                          const DataEnclosures& data);

/// The slabs that take the place of one.
std::vector<SampledSlab> split(const SimplexGeometry& simplex, const SampledLeaf& leaf, const DataEnclosures& data);

} // namespace ndframe
