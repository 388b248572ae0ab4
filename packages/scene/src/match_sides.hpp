#pragma once

#include <map>
#include <memory>
#include <optional>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// A body's mesh, and what it was before it was cut (BodyModel).
struct CutMesh : GivenMesh
{
  explicit CutMesh(GivenMesh given) : GivenMesh(std::move(given)) {}
  Mesh base;
  std::vector<int> parents;
  int uncutPoints = 0;
};

/// Which points of an interface face each other, if that takes more than sides that match.
struct SidePairing
{
  std::shared_ptr<const SideMap> map;     ///< null where the sides match as they are
  std::string gap;                        ///< what a rigid body adds to the gap (ObstacleOutline)
  std::optional<ObstacleSurface> surface; ///< of a rigid body that a solid touches
  std::shared_ptr<const InterfaceMesh>
      drawn{};        ///< the first side before its edges were halved, if they or the other's were
  bool isCut = false; ///< solids whose sides were not the same: pairCutSides
};

/// Cuts the meshes of bodies where interfaces have sides that do not match (insertion), and makes those of rigid
/// bodies that have none yet. Returns the pairing of every interface by its name: without map, too, where something is
/// missing or wrong that reading the interface will tell. A map of an earlier mesh of the same polygons is kept: the
/// scene stays the same. told: meshes are shares of bodies that have been cut; null: they are whole. InputError for
/// rigid bodies that nothing faces.
std::map<std::string, SidePairing> matchSides(const SceneSettings& scene, const SceneComponents& components,
                                              const std::vector<InterfaceMesh>& earlier, std::vector<CutMesh>& meshes,
                                              const ToldScene* told);

} // namespace ndframe
