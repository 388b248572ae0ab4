#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// What a side is apart from how it is meshed: its measure and its corners.
///
/// A vertex is a corner unless the facets around it go on unchanged along a straight line through it: no corner are the
/// vertices inside a straight or flat part, on a straight crease between two flat parts, and on a straight rim. Angles
/// below 1e-7 are round-off. A circle's polygon has a corner at every vertex, so that two meshes of it differ.
struct Outline
{
  double measure = 0.0;        ///< length or area; of a group of cells area or volume
  double size = 0.0;           ///< largest coordinate, what round-off is relative to
  std::vector<double> corners; ///< coordinates, in an order that does not depend on the mesh
};

/// What a body is apart from how it is meshed.
struct MeshOutline
{
  double measure = 0.0;                               ///< area or volume
  std::vector<std::pair<std::string, Outline>> sides; ///< by name; groups of cells are parts, too
};

MeshOutline outlineOf(const Mesh& mesh); ///< by sums over cells and facets

/// Equal but for round-off (1e-11): two meshes of the same polygons with the same sides.
/// Limit: of parts of the boundary that no side names only what they do to the measure is seen.
bool sameOutline(const MeshOutline& a, const MeshOutline& b);

} // namespace ndframe
