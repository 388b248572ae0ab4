#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/block_matrix.hpp"
#include "ndframe/algebra/sparse_field.hpp"
#include "ndframe/assembly/body_share.hpp"
#include "ndframe/assembly/dof_layout.hpp"
#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/mechanics/cell_laws.hpp"

namespace ndframe
{

/// A part of a body with a material of its own.
struct BodyRegion
{
  std::string name;          ///< empty: what is in no region that the deck names
  std::int64_t numCells = 0; ///< of the whole body; they need not follow each other
  int law = 0;               ///< its number among those of the body
};

/// A body as the deck describes it, discretised.
struct BodyModel
{
  std::string name;                               ///< as in the deck
  Mesh mesh;                                      ///< what is solved on: cut where sides do not match
  NodeMap nodes;                                  ///< of the displacements
  CellLaws laws;                                  ///< per cell of `mesh`
  std::vector<std::unique_ptr<Support>> supports; ///< in the order of the deck
  std::vector<std::unique_ptr<Load>> loads;       ///< in the order of the deck
  Mesh base;                ///< the mesh that was cut where sides do not match; empty where `mesh` was not cut
  std::vector<int> parents; ///< then per cell of `mesh` the cell of `base` that it is a part of
  std::shared_ptr<const Mesh> drawn{}; ///< the mesh before its edges were halved (Refine); null: it is that one
  int uncutPoints = 0;  ///< vertices of `mesh` but those that cut facets in the plane, which follow; 0: no such
  bool isRigid = false; ///< an obstacle: `mesh` only shows where it is; all its nodes are held, it carries no stress
  std::vector<BodyRegion> regions{}; ///< none: the body is one part
  std::vector<int> regionOfCell{};   ///< per cell; empty without regions
  /// The rank's part of a body that no rank has: `mesh` and `nodes` are those of the part; null: they are the body's.
  std::shared_ptr<const BodyShare> share{};

  /// The mesh without what other bodies cut into it: what is refined.
  const Mesh& uncut() const { return parents.empty() ? mesh : base; }
  int numDofs() const { return nodes.numNodes() * nodes.dim; } ///< of `nodes`, fixed ones included
  /// Of all ranks.
  std::int64_t totalDofs() const { return (share ? share->numNodes() : nodes.numNodes()) * std::int64_t(nodes.dim); }
  std::int64_t totalCells() const { return share ? share->numCells() : mesh.numCells(); } ///< the same
  double poissonRatio() const; ///< the largest of its materials, as of isotropic ones
  /// Side by name; null if the mesh has none of that name.
  const Side* side(const std::string& sideName) const { return mesh.findSide(sideName); }
};

/// The linear system of one body in its dofs: K u = f + contact forces + reactions.
///
/// K_ij = a(phi_i, phi_j), complete rows of the owned nodes, supports not imposed (the layout says which dofs are
/// fixed).
struct BodySystem
{
  DofLayout dofs;   ///< their axes and roles
  BlockMatrix K;    ///< this rank's rows; forces per length
  SparseField load; ///< f, in the nodes' own axes
  /// Of a body that is shared out: K numbers nodes as the whole body does, all else as the part; null otherwise.
  std::shared_ptr<const BodyShare> share{};
  std::vector<int> partNodes{}; ///< then per node that K holds its number in the part
  double largestOwn = 0.0;      ///< the largest entry of K's diagonal in this rank's rows

  /// f - K u_prescribed: the load once the fixed dofs are moved to their values. Numbered as K.
  SparseField effectiveLoad(const Comm& comm) const;
  /// K u at the dofs of own nodes, zero elsewhere; u at all nodes of the part. Of a shared body. Local.
  Vector productOfPart(const Vector& u) const;
  /// K u of all nodes, or of a shared body that of productOfPart(). Collective.
  Vector forcesOf(const Vector& u, const Comm& comm) const;
  /// The largest entry of the diagonal. Collective.
  double largestDiagonal(const Comm& comm) const;
};

/// Assembles K on the owned nodes; `load`: what integrateLoads gave. Kernels are exact for straight elements.
BodySystem assembleBody(const BodyModel& body, DofLayout dofs, const std::vector<int>& ownedNodes,
                        const SparseField& load);

/// The same, integrating the loads.
BodySystem assembleBody(const BodyModel& body, DofLayout dofs, const std::vector<int>& ownedNodes);

/// Gives back the entries of K, most of a system's memory; what K is for cannot be asked then.
void giveBackStiffness(BodySystem& system);
/// K again, where it was given back.
void assembleAgain(BodySystem& system, const BodyModel& body);

/// f of equation (19) for a set of loads, in the nodes' own axes: a new load case needs nothing else.
NodalField assembleLoad(const BodyModel& body, const Frames& frames);

/// Forces in global axes, as integrateLoads gives them, in the nodes' own axes.
SparseField inOwnAxes(const SparseField& global, const Frames& frames);

} // namespace ndframe
