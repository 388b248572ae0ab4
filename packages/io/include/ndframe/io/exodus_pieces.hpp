#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/io/piece_border.hpp"
#include "ndframe/mesh/piece_name.hpp"

namespace ndframe
{

/// Which piece of a scene each cell belongs to: one piece for each process of a run.
struct ExodusSharing
{
  int pieces = 1;                      ///< how many
  std::vector<std::vector<int>> owner; ///< per body and cell, the piece, from 0
};

/// A cell belongs to the piece of its lowest node, which is a vertex. pieceOfVertex: per body and vertex. Pieces may
/// have no cells: for meshes without fields.
ExodusSharing cellsOfPieces(const std::vector<ExodusBody>& bodies, int pieces,
                            const std::vector<std::vector<int>>& pieceOfVertex);

/// The same for pieces with fields: one that would have no cell gets one of the largest piece, as readers expect the
/// variables of the nodes in every piece. pieceOfVertex: empty: each body's vertices are shared out by
/// mesh/partition.hpp. There must be as many cells as pieces.
ExodusSharing shareCells(const std::vector<ExodusBody>& bodies, int pieces,
                         const std::vector<std::vector<int>>& pieceOfVertex = {});

/// The pieces "NAME.e.N.r" that stand beside "NAME.e", of any N, sorted: regular files, of complete sets or not.
std::vector<std::string> piecesBeside(const std::string& path);

/// Writes one piece of what writeExodus writes: the piece's cells in the order of the whole, their nodes, their facets
/// of all sides, and all fields there, so that pieces together have every value of the whole, bit by bit.
///
/// All pieces have all blocks, side sets and variables. Beside them stand the maps to the node and element numbers of
/// the whole, and Nemesis's records: numbers of the whole, inner and border nodes and elements, and what each other
/// piece has too, in an order that is the same in both. `bodies`, `contactSides` and `steps` are those of the whole.
/// Errors and limits: as writeExodus, and 32-bit numbers for the whole, too.
void writeExodusPiece(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                      const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                      const std::vector<std::string>& infoLines, const ExodusSharing& sharing, int piece);

/// The scene that pieces are shares of, where no process has it whole.
struct ExodusWhole
{
  int pieces = 1, piece = 0;                    ///< their number, and this one's
  std::vector<std::vector<std::int64_t>> nodes; ///< per body and node of the share: its number in the whole body
  std::vector<std::int64_t> numNodes, numCells; ///< per body, of the whole
  std::vector<int> numOwnCells;                 ///< per body: the first cells of the share are the piece's
  /// Per block, of bodies or their parts: its elements in the whole, and those of the pieces before this one.
  std::vector<std::int64_t> numElements, firstElements;
  /// Per body and own cell: its number among the elements of the whole body, whose parts follow each other.
  std::vector<std::vector<std::int64_t>> elements;
  /// Of the whole: per side set, the named sides of all bodies and then the contact sides, the number of facets.
  std::vector<std::int64_t> numFacets;
  std::vector<std::vector<PieceBorder>> borders; ///< per body, with the other pieces; in numbers of the share
};

/// The same of a scene of which a process has a share: `bodies`, `contactSides` and `steps` are the share's, with other
/// cells than the piece's.
void writeExodusShare(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                      const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                      const std::vector<std::string>& infoLines, const ExodusWhole& whole);

} // namespace ndframe
