#pragma once

#include "ndframe/equilibrium/star_body.hpp"

namespace ndframe
{

/// Carries wrenches along the tree of a star to its first cell.
///
/// needed: per cell (wrench x columns) the wrench that the tractions on its tree spokes must have; on return what
/// nothing is left to carry stays in the first cell, the others are zero. Returns per spoke the wrench on its first
/// cell (outward there, its opposite on the second); no columns outside the tree.
std::vector<DenseMatrix> carryAlongTree(const Star& star, const SpanningTree& tree, std::vector<DenseMatrix>& needed);

/// A facet of a star on which the traction along a direction may be changed.
struct ReleasedFacet
{
  Facet facet;           ///< of this body
  Direction direction{}; ///< unit; a traction dt acts on this body as dt * direction
};

/// A traction on a boundary spoke, direction times one mode.
struct GroundTraction
{
  int spoke, mode;
  Direction direction;

  /// Tractions of linear and constant modes carry wrenches, the others are in balance by themselves.
  bool carriesWrench(int dim) const { return mode < dim; }
  void addTo(double* moments, int dim, double amount) const
  {
    for (int i = 0; i < dim; ++i)
      moments[mode * dim + i] += amount * direction[std::size_t(i)];
  }
};

/// The reactions that supports allow on the star's boundary spokes.
std::vector<GroundTraction> reactions(const StarBody& body, const Star& star);

/// Released tractions in the order of the facets, mode by mode.
std::vector<GroundTraction> releasedTractions(const StarBody& body, const Star& star,
                                              const std::vector<ReleasedFacet>& released);

} // namespace ndframe
