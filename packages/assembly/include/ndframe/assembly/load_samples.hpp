#pragma once

#include "ndframe/assembly/adaptive_samples.hpp"
#include "ndframe/assembly/side_condition.hpp"

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
};

/// Visits every facet or cell on which a load acts. A constant load costs a value per simplex; one that varies is
/// sampled anew on facets and, in cells, where Load::addTo() has not kept its projections on this mesh.
void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit);

} // namespace ndframe
