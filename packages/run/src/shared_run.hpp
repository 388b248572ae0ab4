#pragma once

#include "ndframe/run/run_steps.hpp"
#include "ndframe/scene/drawn_pieces.hpp"

namespace ndframe
{

/// Whether ranks can have shares of what a deck describes, as far as it says so without its meshes.
bool mayBeShared(const RunSettings& settings, int ranks);

/// What ranks can have shares of, or what was read to find that they cannot.
struct SceneToShare
{
  DrawnScene drawn;                  ///< on rank 0, or nowhere
  std::optional<DrawnPieces> pieces; ///< where each rank has read its own
  std::optional<ToldScene> told;     ///< on every rank; none: bodies must be whole
};

/// The scene on its meshes as drawn, checked, where ranks can have shares of it: several ranks solve solids whole, by
/// Multigrid, nothing asks for all of a body (a reference of the error), and the meshes are
/// fine enough (areEnough), or all refined. Rank 0 reads, builds and checks it for all, or, where ranks have read
/// pieces of the meshes (readPieces), what lies at the boundaries; its mistakes are all ranks' (InputError). Not for
/// runs with a target, whose first meshes are whole. known: the model before, whose meshes are taken. Collective.
SceneToShare sceneToShare(const Model& known, const RunTools& tools);

/// The same on the meshes of a level, which all ranks have. meshes: of bodies that are not rigid; earlier: interfaces
/// on meshes before (buildModel). Collective.
SceneToShare sceneToShare(const std::vector<Mesh>& meshes, const std::vector<InterfaceMesh>& earlier,
                          const RunTools& tools);

/// The model is this rank's share of the scene. Counts "shared bodies". Collective.
void takeShares(Model& model, SceneToShare&& scene, const std::vector<InterfaceMesh>& earlier, const RunTools& tools);

} // namespace ndframe
