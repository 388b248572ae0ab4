#pragma once

#include <optional>
#include <string>

#include "ndframe/mesh/numbered_mesh.hpp"
#include "ndframe/scene/shared_scene.hpp"

namespace ndframe
{

/// What a rank has of a mesh of which it has read its pieces. Vertices and cells have their numbers in the whole.
struct BodyPieces
{
  using Number = RefinedNumbers::Number;

  NumberedMesh part;       ///< all cells with a vertex of this rank, and some others
  std::vector<int> owners; ///< per point of the part: one of the ranks whose pieces have it
  int halvings = 0;        ///< to come
  /// Of the drawn mesh, whose simplices are counted per number of vertices less one (RefinedNumbers::Whole).
  std::array<Number, 4> counts{};
  Number cells = 0;                 ///< the same
  std::vector<Number> cellsOfKinds; ///< the same: per kind (CellGroups)
  double measure = 0.0;             ///< the same: a volume
  ForcesInside forcesInside;        ///< of all its cells but `outer`
  /// The vertices of its sides of contact, of all ranks, ascending, and who owns each.
  std::vector<Number> touching;
  std::vector<int> touchingOwners;
  /// On rank 0: all cells with a facet of the boundary, or that touch sides of contact, some of each kind, and those
  /// at points that are asked of.
  NumberedMesh outer;
};

/// Points of a body that a scene asks of.
struct AskedPoints
{
  std::vector<std::vector<double>> inCells; ///< which cells hold them: coordinates, perhaps not as many as the body has
  double tolerance = 0.0;                   ///< how far outside they may be, relative to the body's diameter
  std::vector<std::vector<double>> nearVertices; ///< the same: which vertex is nearest
};

/// A scene of which every rank has read its pieces of the meshes (`NAME.e.N`), and no rank the whole.
struct DrawnPieces
{
  std::vector<std::optional<BodyPieces>> bodies; ///< per body; none for rigid ones
  std::int64_t numPieces = 0;                    ///< that this rank has read
};

/// Reads the meshes where all are pieces of files, as many for each rank, and all that a scene needs to know of them is
/// at their boundaries, or at points: solids, each one connected part with a material, perhaps beside regions; bodies
/// that touch each other have the same Refine. None where ranks cannot share them so, or evenly (20 %), or where
/// something is wrong with the pieces, which shows when they are read as a whole. Vertices have the numbers that they
/// would have then. points: per body those asked of besides its supports'. Collective.
std::optional<DrawnPieces> readPieces(const SceneSettings& scene, const SceneComponents& components,
                                      std::vector<AskedPoints> points, const Comm& comm, Ledger& ledger);

/// The scene on the outer cells of the bodies, which are given away, for buildDrawn(). On rank 0.
DrawnScene outerScene(DrawnPieces& pieces);

/// This rank's parts of the drawn bodies that are not rigid, as sharedModel() takes them. Vertices are those
/// of a rank whose pieces have them, contact pairs those of the first body's. drawn: with the model, of rank 0.
/// Collective.
std::vector<DrawnPart> drawnParts(DrawnPieces&& pieces, const DrawnScene& drawn, bool withHalo, const Comm& comm);

} // namespace ndframe
