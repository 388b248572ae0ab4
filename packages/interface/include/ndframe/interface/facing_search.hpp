#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

/// A body whose sides are searched.
struct SearchedBody
{
  const Mesh* mesh;                   ///< not owned; without cells for a body that faces nothing
  std::vector<std::string> preferred; ///< sides that are taken before others that share facets with them
  std::vector<std::string> leftOut;   ///< sides that face nothing

  bool prefers(const Side& side) const { return isOneOf(preferred, side.name); } ///< by the name of the side
  bool leavesOut(const Side& side) const { return isOneOf(leftOut, side.name); } ///< by the name of the side

private:
  static bool isOneOf(const std::vector<std::string>& names, const std::string& name)
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
};

/// A side of a body and another one of this or of a later body, and what of the first one faces the second.
struct FacingPair
{
  /// Place of the first body in the list that is searched.
  int firstBody, secondBody; ///< place of the second body; not smaller
  /// Name of the first body's side.
  std::string firstSide, secondSide; ///< name of the second body's side
  double length = 0.0;               ///< of the first side; an area in space
  /// Smallest opening, a length; for solids 0, as is the largest.
  double smallest = 0.0, largest = 0.0; ///< opening along the first side's normals; negative where polygons overlap
};

/// Facets of no named side that face another body or a side of their own.
struct UnnamedFacing
{
  int body;            ///< whose facets have no name
  int other;           ///< body that they face; may be the same
  Direction place;     ///< on the first of both bodies, in the middle of the longest such part
  double length = 0.0; ///< of all such parts
};

/// What searchFacing() or searchMatching() found.
struct FacingSearch
{
  std::vector<FacingPair> pairs;      ///< in the order of bodies and sides
  std::vector<UnnamedFacing> unnamed; ///< at most one for two bodies and the side of either
};

/// Which named sides in the plane face each other, of different bodies or two of one: rays from the sides of the first
/// body along their normals (SidePolygon, with the corner angle) meet the second one before they meet anything else,
/// within `distance` and what the chords of curves may be off by, on a part of positive length (1e-6 of the shorter
/// side), where the two enclose less than 25 degrees. Corners that meet face nothing.
///
/// Sides that share facets: a preferred one counts; a side that others are parts of counts unless they make all of it;
/// then the longer one counts. What is left of the other one counts as if it had no name.
/// Limits: two dimensions; a side does not face itself; what lies behind another body is not seen.
/// Costs boxes of sides times sides, then edges times edges of sides that are near each other.
FacingSearch searchFacing(const std::vector<SearchedBody>& bodies, double distance, double cornerAngle);

/// Which named sides of solids lie on each other, of different ones or two of one. First those with the same nodes (of
/// one body a slit's, whose nodes are there twice): a side that shares facets with one that has a partner already, or
/// with a preferred one, counts no more. Then flat ones that were meshed apart, of which one may lie on several others.
/// `length` is the common area, the opening zero. unnamed: facets that lie on each other and are in no pair.
FacingSearch searchMatching(const std::vector<SearchedBody>& bodies);

/// Two named sides of different bodies, and how near they come.
struct NearestSides
{
  /// Place of the first body in the list that is searched.
  int firstBody, secondBody; ///< place of the second body; larger
  /// Name of the first body's side.
  std::string firstSide, secondSide; ///< name of the second body's side
  double distance;                   ///< a length; 0: they touch
  Direction place;                   ///< on one of them
};

/// The nearest of all; none for fewer than two bodies with sides.
std::optional<NearestSides> nearestSides(const std::vector<SearchedBody>& bodies);

/// Diagonal of the box around all bodies.
double extentOf(const std::vector<SearchedBody>& bodies);

} // namespace ndframe
