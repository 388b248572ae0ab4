#pragma once

#include "ndframe/scene/drawn_pieces.hpp"

namespace ndframe
{

/// What the deck says of a body whose pieces are read.
struct PieceSettings
{
  std::vector<std::string> contactSides; ///< that may touch other bodies
  AskedPoints points;                    ///< that are asked of
  int halvings = 0;                      ///< to come
  bool choosesBlocks = false;            ///< the files may have sides of others
};

/// What a rank's pieces of a mesh become; none where they do not belong together, or are no single connected part of a
/// solid. own: none where this rank could not read its pieces. Collective.
std::optional<BodyPieces> sharedPieces(std::optional<NumberedMesh> own, const PieceSettings& settings,
                                       const Comm& comm);

// Steps of this and of drawnParts(), in this order. Collective, all of them.

/// The part is what this rank has read; it becomes all cells around own vertices.
void gatherAroundOwn(BodyPieces& body, const Comm& comm);
/// Finds the vertices on sides of contact.
void findTouching(BodyPieces& body, const std::vector<std::string>& sides, const Comm& comm);
/// Rank 0 gets the cells with a facet of the boundary, from the owner of its lowest vertex, those at contact, and from
/// each rank one of each kind, its cells that hold points, or that these are least outside of, and one at its nearest
/// vertex.
void gatherOuter(BodyPieces& body, const AskedPoints& points, const Comm& comm);
/// All parts get the cells at contact.
void addCellsAtContact(BodyPieces& body, const Comm& comm);
/// The part gets all cells that have a vertex in common with one that has an own vertex. Its owners are those in the
/// end (drawnParts).
void addHalo(BodyPieces& body, const Comm& comm);
/// What the part has to be told of the whole.
RefinedNumbers::Whole wholeOf(const BodyPieces& body, const Comm& comm);

} // namespace ndframe
