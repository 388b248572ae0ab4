#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ndframe/mesh/mesh_parts.hpp"
#include "ndframe/mesh/refined_share.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

/// What a rank needs of a drawn mesh to make its share (refinedShare), which is the same as with the whole mesh.
struct DrawnPart
{
  /// Cells with an own vertex, those that touch the sides that all ranks have, and the halo (DrawnParts); all sides.
  Mesh mesh;
  RefinedNumbers numbers; ///< of the whole, by the part's vertices, which ascend as in the whole
  DrawnOwners owners;     ///< of the part's vertices
  int halvings = 0;
};

/// A drawn mesh in parts, one after the other. Needs a few bytes a cell besides the mesh. What is given must live as
/// long.
class DrawnParts
{
public:
  /// sides: names of those that all ranks have. halvings: to come. withHalo: with all cells that have a vertex
  /// in common with one that has an own vertex, for shares with a halo.
  DrawnParts(const Mesh& drawn, int halvings, const RefinedNumbers& numbers, const DrawnOwners& owners,
             const std::vector<std::string>& sides, int ranks, bool withHalo = false);

  /// The part of a rank, as bytes for drawnPartFromBytes().
  std::string bytesOf(int rank);

private:
  void addHalo(int rank, std::vector<int>& cells) const;

  const RefinedNumbers& numbers_;
  const DrawnOwners& owners_;
  const Mesh& mesh_;
  int halvings_;
  MeshParts parts_;
  std::optional<VertexCells> around_;   ///< where there is a halo
  std::vector<int> common_;             ///< cells of all ranks, ascending
  std::vector<std::vector<int>> cells_; ///< per rank the others that it needs, the same
};

/// Reads what DrawnParts has made; anything else is a bug (InternalError).
DrawnPart drawnPartFromBytes(std::string_view bytes);

} // namespace ndframe
