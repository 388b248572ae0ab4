#pragma once

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/interface/obstacle.hpp"
#include "ndframe/mechanics/material_law.hpp"
#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe
{

/// What scenes are made of. Builders keep references between registries: the object stays where it was made.
struct SceneComponents
{
  Registry<MeshSource> meshSources{"mesh"};                 ///< lists Mesh
  Registry<MaterialLaw> materials{"material", "Isotropic"}; ///< lists Material
  Registry<Support> supports{"support"};                    ///< entries of Supports
  Registry<Load> loads{"load"};                             ///< entries of Loads
  Registry<Obstacle> obstacles{"rigid body"};               ///< lists Rigid

  SceneComponents() = default;
  SceneComponents(const SceneComponents&) = delete;
  SceneComponents& operator=(const SceneComponents&) = delete;
};

} // namespace ndframe
