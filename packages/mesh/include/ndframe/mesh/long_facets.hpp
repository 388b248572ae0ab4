#pragma once

#include <functional>

#include "ndframe/mesh/cut_facets.hpp"

namespace ndframe
{

/// A boundary facet of one of several meshes, and how long it is beside another one.
struct MeasuredFacet
{
  int mesh;      ///< its number among them
  Facet facet;   ///< of this mesh
  double length; ///< in any unit that both facets of a pair share
};

using MeasuredPair = std::array<MeasuredFacet, 2>; ///< facets that touch

/// Halves cells (Bisection, TetrahedronBisection), each mesh for itself, until no facet of a pair is more than twice as
/// long as the other one.
///
/// meshes: without parents where nothing was done. pairs: the facets of these meshes that lie on or face each other;
/// called before every round. Returns false where 60 rounds are not enough: in the plane they always are, for a cell's
/// edge on the boundary is halved every second time at least.
[[nodiscard]] bool halveLongFacets(std::vector<DerivedMesh>& meshes,
                                   const std::function<std::vector<MeasuredPair>()>& pairs);

} // namespace ndframe
