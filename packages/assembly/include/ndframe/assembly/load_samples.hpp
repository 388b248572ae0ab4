#pragma once

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A facet or cell on which a load acts, with the load's density there.
struct LoadedSimplex
{
  bool isCell = false;           ///< q is a force per volume; else per area, on a facet
  Facet facet{};                 ///< only the cell counts when isCell
  std::array<int, 4> vertices{}; ///< as facetVertices or Mesh::cell give them; the samples' points refer to this order
  double measure = 0.0;          ///< length, area or volume
  Samples samples;               ///< of q, dim components
  /// In place of values at points: coefficients of q's L2 projection on the first functions of
  /// MomentBasis::polynomials, for the vertices in ascending order, dim components each; samples.rest is its distance.
  /// Null: there are points.
  const double* projection = nullptr;
  int functions = 0; ///< of the projection
};

/// Where the simplex's vertices stand in ascending order.
std::array<int, 4> ascendingPlaces(const LoadedSimplex& simplex);

/// Visits every facet or cell on which a load acts. A constant load costs a value per simplex; one that varies is
/// sampled anew on facets and, in cells, where the load has not kept its projections (BodyLoads) on this mesh; these
/// are visited then.
void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit);

} // namespace ndframe
