#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A body's boundary as seen by others: where its points may lie on or in another body.
struct BoundaryView
{
  const Mesh* mesh = nullptr;
  std::vector<Facet> facets;            ///< of the boundary
  std::set<std::pair<int, int>> paired; ///< (cell, local) of those that an interface joins to the other body
  int numCells = -1;                    ///< the first cells are looked at; -1: all

  int lookedAt() const { return numCells < 0 ? mesh->numCells() : numCells; }
};

/// An inner point of a facet.
struct BoundaryPoint
{
  std::array<double, 3> x{}, normal{};
};

/// Where a point with a normal stands to a body.
struct Standing
{
  bool inside = false;                               ///< in a cell
  bool touches = false;                              ///< on the boundary, facing it
  double depth = std::numeric_limits<double>::max(); ///< distance from the boundary facets of the cells that hold it

  void add(const Standing& other) ///< what other cells of the body say
  {
    inside = inside || other.inside;
    touches = touches || other.touches;
    depth = std::min(depth, other.depth);
  }
};

/// What one boundary does to another body.
struct Encounter
{
  std::array<double, 3> deepest{};               ///< the point of the first body that lies deepest in the second
  double depth = 0.0;                            ///< of it; 0: no point lies inside
  std::optional<std::array<double, 3>> touching; ///< a point where boundaries coincide
};

/// How far from a box others may be that it meets, for bodies of these diameters.
double reachOf(double diameter, double other);

/// Those of the facets, but the paired ones.
std::vector<BoundaryPoint> pointsOf(const BoundaryView& body);

std::vector<Standing> standingsOf(const std::vector<BoundaryPoint>& points, const BoundaryView& body, double reach);

/// What points do to a body to which they stand so.
Encounter encounterAt(const std::vector<BoundaryPoint>& points, const std::vector<Standing>& standings);

/// The deeper of two, a point of contact from either.
Encounter deeperOf(Encounter one, const Encounter& other);

/// Looks for points of the facets of `first` (but the paired ones) that lie in cells of `second` or on its boundary.
/// The points are some inner ones of every facet: what is smaller than a third of a facet may stay unseen. Both meshes
/// must have positive cells; depth is the distance from the nearest plane of a boundary facet of the cell that holds
/// the point, or of the cell's size in cells away from the boundary.
Encounter encounter(const BoundaryView& first, const BoundaryView& second);

/// Pairs (a < b) of meshes whose boxes meet, in ascending order: the others have no encounter.
std::vector<std::pair<int, int>> nearPairs(const std::vector<const Mesh*>& meshes);

/// Both ways.
Encounter encounterOf(const BoundaryView& a, const BoundaryView& b);

} // namespace ndframe
