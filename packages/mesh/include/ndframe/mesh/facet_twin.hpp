#pragma once

#include <array>
#include <utility>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// One facet seen from two meshes: a facet of each, and they lie on each other. `first` and `second` number the meshes.
struct FacetTwin
{
  int first;         ///< number of a mesh
  Facet firstFacet;  ///< of it
  int second;        ///< number of the other mesh
  Facet secondFacet; ///< of it
};

/// The vertices of two facets of tetrahedra that lie on each other, with their bodies on different sides: which are at
/// the same place.
std::array<std::pair<int, int>, 3> sameVertices(const Mesh& a, Facet facetA, const Mesh& b, Facet facetB);

} // namespace ndframe
