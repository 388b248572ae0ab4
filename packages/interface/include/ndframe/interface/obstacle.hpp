#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ndframe/base/registry.hpp"
#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

/// A rigid body as one side of a plane body sees it: edges as those of a side, and what stands between them and the
/// body, an expression in x and y (a length along n) that is a part of the gap.
struct ObstacleOutline
{
  SidePolygon polygon; ///< rigid body to the left of its edges; without edges nothing of it faces the side
  std::string gap;     ///< empty: nothing
};

/// A rigid body as one side of a solid sees it.
struct ObstacleSurface
{
  std::vector<Facet> facets;       ///< of the side, those that face it; none: nothing does
  std::optional<Direction> normal; ///< n_c on all of them where it is the body's; none: each has its own
  std::string gap;                 ///< a length along n_c, an expression in x, y and z that is a part of the gap
};

/// A rigid body, given by a formula.
class Obstacle
{
public:
  virtual ~Obstacle() = default;
  /// What of it may touch the side. No edges: nothing.
  virtual ObstacleOutline facing(const SidePolygon& side) const = 0;
  /// The same for facets of a solid.
  virtual ObstacleSurface facing(const Mesh& mesh, const std::vector<Facet>& facets) const = 0;
};

/// "Plane", "Cylinder", "Sphere", "Expression".
void registerObstacles(Registry<Obstacle>& registry);

/// Adds to `mesh` a strip of triangles behind the part of the map's second side that faces the facets, with a vertex
/// where one of theirs faces it; its side is called `name`. Sides of bodies that are not meshed are made so.
void addStrip(Mesh& mesh, const std::string& name, const SideMap& map, const Mesh& first,
              const std::vector<Facet>& facets);

/// Adds to `mesh` a layer of tetrahedra behind the facets that face a rigid body, on which it lies; its side is called
/// `name`. The gap stands in the formula, not between the meshes.
void addLayer(Mesh& mesh, const std::string& name, const Mesh& first, const ObstacleSurface& surface);

} // namespace ndframe
