#pragma once

#include <map>
#include <utility>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A mesh made of another one.
struct DerivedMesh
{
  Mesh mesh;                ///< the new one
  std::vector<int> parents; ///< per cell the cell of the other one that it is a part of
  int uncutPoints = 0;      ///< points that were there before cutFacets(); those that cut follow
};

/// Places on facets of a triangle mesh where vertices are wanted: by cell and local number of the facet, from 0 at its
/// first vertex (facetVertices) to 1, ascending, strictly between.
using FacetCuts = std::map<std::pair<int, int>, std::vector<double>>;

/// Gives boundary facets of a triangle mesh new vertices: their cells become fans around the opposite vertices. The
/// body stays what it is with its groups of cells, as do its other cells' facets; points and cells keep their numbers,
/// new ones follow. The parts of a side's facet stand where it stood, in the direction of facetVertices.
DerivedMesh cutFacets(const Mesh& mesh, const FacetCuts& cuts);

/// Of a mesh that stays as it is: each cell is its own parent.
std::vector<int> ownNumbers(const Mesh& mesh);

/// Makes `first`, which has no parents where nothing was done, and then `second` of its mesh one step.
DerivedMesh compose(const DerivedMesh& first, DerivedMesh second);

} // namespace ndframe
