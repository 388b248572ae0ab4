#pragma once

#include <memory>

#include "ndframe/equilibrium/body_piece.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// What a rank holds of a scene whose cells are shared out by place (partitionByPlace).
struct ScenePieces
{
  std::vector<std::unique_ptr<BodyPiece>> bodies; ///< null for rigid ones
  /// As those of the scene; facets by their numbers in the pieces, the cell is -1 where it is not held.
  std::vector<ContactPatch> patches;
};

/// together: bodies are shared out as one, and what faces a held vertex in contact is held, too; else every body is
/// shared among all ranks. What the scene points to must outlive the pieces. Collective.
std::shared_ptr<const ScenePieces> cutScene(const RecoveryScene& scene, bool together, const Comm& comm);

/// All ranks get the corrections of all cells, 0.7 kB a cell of order 2. Collective.
void gatherPieces(const ScenePieces& pieces, std::vector<StressCorrection>& corrections, const Comm& comm);

} // namespace ndframe
