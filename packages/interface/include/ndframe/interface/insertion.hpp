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
  /// Place of the first body in the list of meshes.
  int firstBody = 0, secondBody = 0; ///< place of the second body; may be the same
  /// Name of the first body's side.
  std::string firstSide, secondSide;  ///< name of the second body's side
  std::shared_ptr<const SideMap> map; ///< in the plane
  bool isCut = false; ///< in space: sides that do not match as they are; the others are named for the edges they share
};

/// Meshes of bodies that match along the map of every interface: vertices of either side that face inside a facet of
/// the other one cut it (cutFacets). Pieces of facets (facingPieces) are whole facets on both sides then.
///
/// Before, cells are halved (Bisection) until no facet is more than twice as long as one that it faces, and on straight
/// sides that lie on each other vertices within 5 % of an edge of a vertex of the other side are moved to it, along the
/// side, so that no short facets come about; corners, and where a named side ends, stay.
///
/// In space sides lie on each other where they are flat, up to round-off: both get the vertices of the other one,
/// those where edges cross, and the same triangles between them (splitFacets). Before, cells are halved as in the
/// plane, and vertices within a tenth of the edges there are moved to a vertex or onto an edge of the other side. All
/// interfaces of a body have to be named, for they may share edges.
///
/// Per body; without parents where nothing was done. Throws CannotCut as cutSolids() does.
std::vector<DerivedMesh> insertion(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces);

/// Gives straight sides a vertex where the other one ends, for stresses are large there: moves one along the side, or
/// cuts the facet; of solids it moves vertices within half of the edges there and, where meshes will be refined, cuts
/// the facets along what is left. Unlike insertion() it changes what is refined later. Returns which bodies' meshes
/// were changed.
std::vector<char> addSideEnds(std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces,
                              const std::vector<char>& isRigid, bool willBeRefined);

} // namespace ndframe
