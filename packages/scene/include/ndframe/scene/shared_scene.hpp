#pragma once

#include <optional>

#include "ndframe/mesh/drawn_parts.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What the cells at the boundary of a body do not say of all its cells.
struct InsideOfBody
{
  double measure = 0.0;                   ///< a volume
  std::vector<std::int64_t> cellsOfKinds; ///< per kind (CellGroups)
  ForcesInside forces;
};

/// A scene on the meshes as they are drawn, which are refined, if at all, after they have been shared out. One rank has
/// it.
struct DrawnScene
{
  std::vector<Mesh> meshes; ///< per body, until the model is built; of rigid bodies none
  /// Per body what it was before the first halving that has been; null: none has.
  std::vector<std::shared_ptr<const Mesh>> before;
  std::vector<int> asked;              ///< per body: halvings of its mesh as read (halvingsOf); zero for rigid bodies
  std::vector<int> halvings;           ///< per body: those of them that are to come
  std::vector<RefinedNumbers> numbers; ///< per body, with these; none where ranks cannot share them out (areEnough)
  std::optional<Model> model;          ///< on the meshes
  /// Where `meshes` are only cells at the boundary, and no rank has the others, per body; else none.
  std::vector<InsideOfBody> inside;
};

/// What so many ranks share out at least: METIS shares out fewer vertices unevenly.
std::int64_t fewestVertices(int ranks);

/// The sides of a body that may touch another one.
std::vector<std::string> contactSides(const SceneSettings& scene, const std::string& body);

/// Reads the meshes as drawn, but for those that `known` has, and refines them until bodies that touch have as many
/// halvings to come (none where their sides do not match: they will be cut), and so many ranks can share them out
/// evenly, but not further than they will be. All mistakes are reported at once (InputError).
DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Model& known, int ranks,
                     Ledger& ledger);

/// Whether so many ranks can share the meshes out: solids that have some 200 vertices a rank, or all will be refined.
bool areEnough(const DrawnScene& drawn, int ranks);

/// Degrees of freedom of second order of a body on its refined mesh.
std::int64_t refinedDofs(const DrawnScene& drawn, int body);

/// The scene on other meshes than those that the deck names, none of which is to be halved. meshes: per body that is
/// not rigid.
DrawnScene drawnOn(const std::vector<Mesh>& meshes, const SceneSettings& scene, int ranks);

/// Whether the vertices that supports hold, of meshes that will be refined, are drawn: of others no rank could say what
/// their supports leave free.
bool drawsHeldPoints(const DrawnScene& drawn, const SceneSettings& scene);

/// Makes the model. earlier, InputError: like buildModel(); InsideNeeded (scene/holds.hpp): of outer cells alone none
/// can be made.
void buildDrawn(DrawnScene& drawn, const SceneSettings& scene, const SceneComponents& components,
                const std::vector<InterfaceMesh>& earlier, Ledger& ledger);

/// What ranks are told of the scene on the refined meshes; without warnings.
ToldScene told(const DrawnScene& drawn);

/// The meshes that need not be read again, for updateModel().
std::vector<Mesh> meshesOf(DrawnScene&& given, const SceneSettings& scene);

/// This rank's parts of the drawn bodies that are not rigid. drawn: with the model, of rank 0, empty elsewhere; it is
/// handed out in parts (DrawnParts), one after the other, and given back. Drawn vertices are shared out by METIS as one
/// graph of all bodies (joinedVertices). withHalo: for shares with a halo. Collective.
std::vector<DrawnPart> drawnParts(DrawnScene&& drawn, const SceneSettings& scene, bool withHalo, const Comm& comm);

/// The scene on the refined meshes, of which this rank has its share: the nodes that go with its drawn vertices
/// (DrawnOwners), with the cells around them, and the cells at contact on every rank. Interfaces are the same on all
/// ranks, to the bit, but for the numbers of nodes and cells. What is said of bodies as a whole (rigid motions that
/// supports leave free) is what all ranks are told. Loads and constraints are those of the part: complete at own nodes,
/// constraints at all. earlier: like buildModel(), the same on all ranks. withHalo: cells with a vertex of an own cell
/// are there, too. Collective.
///
/// drawn: per body that is not rigid.
Model sharedModel(std::vector<DrawnPart> drawn, ToldScene told, const SceneSettings& scene,
                  const SceneComponents& components, const std::vector<InterfaceMesh>& earlier, bool withHalo,
                  const Comm& comm, int threads);

} // namespace ndframe
