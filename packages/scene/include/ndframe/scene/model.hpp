#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/interface/interface_mesh.hpp"
#include "ndframe/scene/recipe.hpp"
#include "ndframe/scene/scene_components.hpp"
#include "ndframe/scene/scene_settings.hpp"
#include "ndframe/scene/told_scene.hpp"

namespace ndframe
{

/// A support Hold and what it holds (scene/holds.hpp).
struct HeldMean
{
  int body = 0;                     ///< index into Model::bodies
  std::size_t support = 0;          ///< index into the body's supports
  DenseMatrix motions;              ///< orthonormal columns in the body's rigid basis
  std::vector<NodeConstraint> pins; ///< as many, where the system is fixed; none where ranks have shares
  /// As many as motions: weights of the displacement (numNodes * dim) in the mean that vanishes; of a share those of
  /// its own cells.
  std::vector<NodalField> means;
};

/// One body at an interface node.
struct NodeSide
{
  /// Index into Model::bodies.
  int body = 0, node = 0;                  ///< node of the body
  ContactRole role = ContactRole::Neumann; ///< of the body on the interface
  bool isFree = false;                     ///< false where supports prescribe its displacement along n_c
  double held = 0.0;                       ///< that displacement
};

/// What the loads on the cells of a body that are not there (Model::isOuter) do.
struct ForcesInside
{
  Vector work;      ///< per mode of its rigid basis; empty: there are none
  Vector magnitude; ///< the same: sum of |force| |displacement|
  double sum = 0.0; ///< of the absolute values of all components
};

/// The scene: what the deck says, read and checked, before anything is assembled.
struct Model
{
  std::vector<BodyModel> bodies;            ///< in the order of the deck
  std::vector<ConstraintSet> constraints;   ///< per body
  std::vector<SparseField> loads;           ///< per body: int q . v in global axes, as integrateLoads gives it
  std::vector<RigidBasis> rigid;            ///< per body
  std::vector<DenseMatrix> freeMotions;     ///< per body: columns span the rigid motions that its supports leave free
  std::vector<DenseMatrix> balancedMotions; ///< per body: those of its rigid motions without support along which
                                            ///< contact pushes; its traction must balance the loads along them
  DenseMatrix jointMotions;                 ///< of all bodies together that Holds fix (freeTogether)
  std::vector<HeldMean> holds;              ///< one per support Hold
  std::vector<InterfaceMesh> interfaces;    ///< in the order of the deck
  ContactConditions conditions = ContactConditions::Nodal; ///< on all interfaces
  std::vector<std::optional<ForcesInside>> inside;         ///< per body; none where all cells are there
  bool solvesWhole = false; ///< whether bodies in contact may be solved by iterations on all of them together
  SceneRecipe recipe;       ///< what it was made from; empty when it is not to be reused
  /// Of a scene of which ranks have shares: what is told of its bodies as a whole; null otherwise.
  std::shared_ptr<const ToldScene> told;

  /// The Dirichlet and the Neumann side of an interface node.
  std::array<NodeSide, 2> sidesAt(const InterfaceMesh& interface, int node) const;
  /// False where supports prescribe the normal displacement of an interface node on both bodies.
  bool carriesContact(const InterfaceMesh& interface, int node) const;

  /// Only cells at the boundary are there, each body being one connected part (DrawnScene).
  bool isOuter() const
  {
    return std::any_of(inside.begin(), inside.end(), [](const auto& ofBody) { return ofBody.has_value(); });
  }
  int bodyIndex(const std::string& name) const; ///< -1 if there is none
  std::vector<int> elasticBodies() const;       ///< the numbers of the bodies that are not rigid
  std::vector<int> numDofs() const;    ///< per body, of all ranks, as far as an int goes: the same on all of them
  bool touches(int body) const;        ///< whether a body has a part in an interface
  double diameterOf(int body) const;   ///< of its whole mesh
  BodyOutline outline(int body) const; ///< for the choice of its solver
  std::int64_t totalDofs() const;      ///< of the elastic bodies
};

/// Reads the meshes, builds the node maps, pairs the sides and checks all of it. Every mistake that can be found is
/// reported at once (InputError): sides that do not exist, hypotheses that do not suit the mesh, sides that do not
/// match, bodies that overlap, bodies that nothing holds.
Model buildModel(const SceneSettings& scene, const SceneComponents& components);

/// Makes an earlier (or empty) model this scene's. What it was made from in the same way stays: everything, or the
/// meshes and node maps of bodies. Counts "meshes reused". Rank 0 reads the meshes for all. A deck that is refused
/// leaves the model as it was. drawn: none, or per body its mesh as drawn, where rank 0 has read it (dim 0: it has
/// not).
void updateModel(Model& model, const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                 Ledger& ledger, std::vector<Mesh> drawn = {});

/// A mesh and its node map, which is made when it is empty.
struct GivenMesh
{
  /// givenNodes: of this mesh, with the order of the deck; empty: made when the body is built.
  GivenMesh(Mesh givenMesh, NodeMap givenNodes = {}, std::shared_ptr<const Mesh> before = {})
      : mesh(std::move(givenMesh)), nodes(std::move(givenNodes)), drawn(std::move(before))
  {}
  Mesh mesh;     ///< before it is cut at others
  NodeMap nodes; ///< empty: made when the body is built
  /// Of a rank's part of a body (BodyModel::share), which has been cut; null: the mesh is the body's.
  std::shared_ptr<const BodyShare> share{};
  /// Of a mesh that has the outer cells of a body alone (Model::isOuter); else none.
  std::optional<ForcesInside> inside{};
  std::shared_ptr<const Mesh> drawn; ///< before its edges were halved: its facets say how n turns; null: it is `mesh`
};

/// The mesh of a body; of a rigid one an empty mesh if it has to be made.
using MeshOfBody = std::function<GivenMesh(const BodySettings& body)>;

/// The same scene on other meshes than those that the deck names. Directions of contact are those of the meshes as
/// drawn (GivenMesh::drawn). earlier: the interfaces of this scene on meshes before; a side that still is the same
/// polygon keeps their normals (inheritNormals). threads: for loads that are sampled; their number changes no bit.
/// told: meshes are shares of the bodies of this scene, which is checked as a whole where it was told.
Model buildModel(const SceneSettings& scene, const SceneComponents& components, const MeshOfBody& meshOf,
                 const std::vector<InterfaceMesh>& earlier = {}, int threads = 1,
                 std::shared_ptr<const ToldScene> told = {});

/// The same as a stage of a run; model.interfaces are the earlier ones. Not to be reused: the model has no recipe.
void remeshModel(Model& model, const SceneSettings& scene, const SceneComponents& components, const MeshOfBody& meshOf,
                 const Comm& comm, Ledger& ledger);

/// Refuses bodies that are the Dirichlet body of one interface and the Neumann body of another: a coupling that solves
/// the bodies one after the other needs one role per body. Looks at the deck only.
void checkRoles(const SceneSettings& scene, Diagnostics& diagnostics);

/// Refuses bodies with rigid motions that neither supports nor contact can stop, naming the motions.
void checkHeld(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

/// "roller at left; by contact: translation along y"
std::string heldBy(const Model& model, int body);

} // namespace ndframe
