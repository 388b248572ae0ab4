#pragma once

#include <array>
#include <string>

#include "ndframe/mesh/cut_facets.hpp"

namespace ndframe
{

/// Two sides of solids that may touch.
struct SolidSides
{
  /// Place of the first body in the list of meshes.
  int firstBody = 0, secondBody = 0; ///< place of the second body; may be the same
  /// Name of the first body's side.
  std::string firstSide, secondSide; ///< name of the second body's side
  bool isCut = false; ///< they do not match as they are; others are named for the edges they share with such sides
};

/// Meshes of solids whose sides have common facets wherever they lie on each other, flat and in one plane up to
/// round-off:
///   1. cells are halved (TetrahedronBisection) until no facet is more than twice as long as one that it lies on;
///   2. vertices within a fifth of the edges there are moved, within flat parts of a side, to a vertex or onto an edge
///   of
///      the other side, unless a cell would become flat;
///   3. both sides get the vertices of the other one, those where edges cross, and the same triangles between them
///      (overlay, splitFacets), again until sides that share edges agree.
/// Per body; without parents where nothing was done. Bodies, loads and supports stay what they are. Throws CannotCut
/// where edges that are led through vertices cross or cells turn over however little is moved.
std::vector<DerivedMesh> cutSolids(const std::vector<Mesh>& meshes, const std::vector<SolidSides>& interfaces);

/// Where one of two sides ends or turns inside the other one, moves vertices of the other one there that are within
/// half of the shortest edges: stresses are large at such a rim, and cells should end at it. Returns which of the two
/// meshes were changed.
std::array<bool, 2> moveToRims(Mesh& first, const std::string& firstSide, Mesh& second, const std::string& secondSide);

/// Gives a side of a solid vertices and edges where another side that lies on it ends or turns. Returns whether it was
/// cut: where cells would turn over it is not.
bool cutAtRims(Mesh& mesh, const std::string& side, const Mesh& other, const std::string& otherSide);

} // namespace ndframe
