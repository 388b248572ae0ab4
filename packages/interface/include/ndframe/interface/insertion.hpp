#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/interface/side_map.hpp"
#include "ndframe/mesh/cut_facets.hpp"

namespace ndframe
{

/// An interface whose sides do not match.
struct FacingSides
{
  int firstBody = 0, secondBody = 0;
  std::string firstSide, secondSide;
  std::shared_ptr<const SideMap> map;
};

/// Meshes of bodies that match along the map of every interface: vertices of either side that face inside a facet of
/// the other one cut it (cutFacets). Pieces of facets (facingPieces) are whole facets on both sides then.
///
/// Before, cells are halved (Bisection) until no facet is more than twice as long as one that it faces, and on straight
/// sides that lie on each other vertices within 5 % of an edge of a vertex of the other side are moved to it, along the
/// side, so that no short facets come about; corners, and where a named side ends, stay.
/// Per body; without parents where nothing was done. Two dimensions.
std::vector<DerivedMesh> insertion(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces);

/// Gives straight sides a vertex where the other one ends, for stresses are large there: moves one along the side, or
/// cuts the facet. Unlike insertion() it changes what is refined later. Returns which bodies' meshes were changed.
std::vector<char> addSideEnds(std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces,
                              const std::vector<char>& isRigid);

} // namespace ndframe
