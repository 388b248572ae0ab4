#pragma once

#include <memory>
#include <string>

#include "ndframe/base/registry.hpp"
#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

/// A rigid body as one side sees it: edges as those of a side, and what stands between them and the body, an expression
/// in x and y (a length along n) that is a part of the gap.
struct ObstacleOutline
{
  SidePolygon polygon;
  std::string gap; ///< empty: nothing
};

/// A rigid body, given by a formula.
class Obstacle
{
public:
  virtual ~Obstacle() = default;
  /// What of it may touch the side. No edges: nothing.
  virtual ObstacleOutline facing(const SidePolygon& side) const = 0;
};

/// "Plane", "Cylinder", "Expression". Limit: two dimensions.
void registerObstacles(Registry<Obstacle>& registry);

/// Adds to `mesh` a strip of triangles behind the part of the map's second side that faces the facets, with a vertex
/// where one of theirs faces it; its side is called `name`. Sides of bodies that are not meshed are made so.
void addStrip(Mesh& mesh, const std::string& name, const SideMap& map, const Mesh& first,
              const std::vector<Facet>& facets);

} // namespace ndframe
