#pragma once

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
};

/// What one boundary does to another body.
struct Encounter
{
  std::array<double, 3> deepest{};               ///< the point of the first body that lies deepest in the second
  double depth = 0.0;                            ///< of it; 0: no point lies inside
  std::optional<std::array<double, 3>> touching; ///< a point where boundaries coincide
};

/// Looks for points of the facets of `first` (but the paired ones) that lie in cells of `second` or on its boundary.
/// The points are some inner ones of every facet: what is smaller than a third of a facet may stay unseen. Both meshes
/// must have positive cells; depth is the distance from the nearest plane of a boundary facet of the cell that holds
/// the point, or of the cell's size in cells away from the boundary.
Encounter encounter(const BoundaryView& first, const BoundaryView& second);

/// Pairs (a < b) of meshes whose boxes meet, in ascending order: the others have no encounter.
std::vector<std::pair<int, int>> nearPairs(const std::vector<const Mesh*>& meshes);

/// Both ways: the deeper of two, a point of contact from either.
Encounter encounterOf(const BoundaryView& a, const BoundaryView& b);

} // namespace ndframe
