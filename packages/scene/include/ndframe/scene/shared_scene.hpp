#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// A scene on the meshes as they are drawn, which are refined after they have been shared out.
struct DrawnScene
{
  std::shared_ptr<Model> model;
  std::vector<int> halvings; ///< per body, of its mesh (halvingsOf); zero for rigid bodies
};

/// Reads the meshes as drawn and refines them until ranks can share them out evenly, but not further than they will be.
/// Rank 0 reads for all. InputError like buildModel(). Collective.
DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Comm& comm, Ledger& ledger);

/// Degrees of freedom of second order of a body on its refined mesh.
std::int64_t refinedDofs(const DrawnScene& drawn, int body);

/// Why ranks cannot have shares of these bodies (BodyShare); empty: they can.
std::string needsWhole(const DrawnScene& drawn);

/// The scene on the refined meshes, of which this rank has its share: the nodes that go with its drawn vertices
/// (DrawnOwners), with the cells around them, and the cells at contact on every rank. Interfaces are the same on all
/// ranks, to the bit, but for the numbers of nodes and cells. What the drawn scene says of bodies as a whole (rigid
/// motions that supports leave free) is taken from it. Loads and constraints are those of the part: complete at own
/// nodes, constraints at all. withHalo: cells with a vertex of an own cell are there, too. Collective.
///
/// Drawn vertices are shared out by METIS as one graph of all bodies (joinedVertices).
Model sharedModel(const DrawnScene& drawn, const SceneSettings& scene, const SceneComponents& components, bool withHalo,
                  const Comm& comm, int threads);

} // namespace ndframe
