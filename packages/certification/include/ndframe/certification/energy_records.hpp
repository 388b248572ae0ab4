#pragma once

#include <string>
#include <vector>

#include "ndframe/estimation/energy_bracket.hpp"
#include "ndframe/mesh/outline.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What the exact solution depends on: the polygons of the bodies with their sides, materials, supports, loads and
/// interfaces. Meshes of the same polygons, orders of elements, couplings and tolerances do not matter.
/// Limit: interfaces whose Dirichlet and Neumann side changed places in the deck count as others.
struct SceneIdentity
{
  SceneIdentity(const SceneSettings& scene, const Model& model); ///< model: of this scene, on any mesh
  bool operator==(const SceneIdentity& other) const;             ///< polygons are the same but for round-off (1e-11)

private:
  std::string data_; ///< lists of the deck
  std::vector<MeshOutline> bodies_;
};

/// The energy records of all scenes that a run or a study has met.
class EnergyRecords
{
public:
  /// What the certificates from now on are called, "case 2"; nothing in a run of its own.
  void begin(const std::string& run) { run_ = run; }

  /// The scene's record; an empty one when it is met for the first time.
  EnergyRecord& of(SceneIdentity scene);

  /// The name of a certificate of the present run; level: 0 in a run without levels.
  std::string name(int level) const;

private:
  std::string run_;
  std::vector<std::pair<SceneIdentity, EnergyRecord>> records_;
};

} // namespace ndframe
