#pragma once

#include <vector>

#include "ndframe/io/exodus_pieces.hpp"

namespace ndframe
{

/// What a piece has of one body.
struct PieceBody
{
  Mesh mesh;                ///< its sides only
  NodeMap nodes;            ///< of the piece's cells
  std::vector<int> ofBody;  ///< per node of the piece: node of the body, ascending
  std::vector<int> cells;   ///< per cell of the piece: cell of the body, ascending
  std::vector<int> inPiece; ///< per cell of the body: cell of the piece, or -1
};

/// What a piece has of a scene.
class PieceScene
{
public:
  PieceScene(const std::vector<ExodusBody>& bodies, const std::vector<ExodusContactSide>& contactSides,
             const ExodusSharing& sharing, int piece);
  PieceScene(const PieceScene&) = delete;
  PieceScene& operator=(const PieceScene&) = delete;

  const std::vector<PieceBody>& parts() const { return parts_; }
  const std::vector<ExodusBody>& bodies() const { return bodies_; } ///< of the piece, one for each of the scene
  const std::vector<ExodusContactSide>& sides() const { return sides_; }
  ExodusStep restricted(const ExodusStep& step) const; ///< of the scene

private:
  std::vector<PieceBody> parts_;
  std::vector<ExodusBody> bodies_; ///< refer to parts_
  std::vector<ExodusContactSide> sides_;
  std::vector<std::vector<int>> facets_; ///< per contact side and facet of the piece: its number in the scene
};

} // namespace ndframe
