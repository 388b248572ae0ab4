#pragma once

#include <map>
#include <memory>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// A body's mesh, and what it was before it was cut (BodyModel).
struct CutMesh : GivenMesh
{
  explicit CutMesh(GivenMesh given) : GivenMesh(std::move(given)) {}
  Mesh base;
  std::vector<int> parents;
};

/// Cuts the meshes of plane bodies where interfaces have sides that do not match (insertion). Returns the map of every
/// interface by its name: null where the sides match as they are, or where something is missing or wrong that reading
/// the interface will tell. A map of an earlier mesh of the same polygons is kept: the scene stays the same.
std::map<std::string, std::shared_ptr<const SideMap>>
matchSides(const Params& deck, const std::vector<InterfaceMesh>& earlier, std::vector<CutMesh>& meshes);

} // namespace ndframe
