#pragma once

#include <vector>

#include "ndframe/algebra/field.hpp"
#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/assembly/constraint_set.hpp"

namespace ndframe
{

/// Axes of the displacement components at each node. Most nodes use x, y, z; nodes on inclined rollers or interfaces
/// have axes of their own, so that every prescribed or kept component is a dof.
class Frames
{
public:
  Frames(int dim, int numNodes) : dim_(dim), numNodes_(numNodes) {} ///< x, y, z at all nodes

  bool isTurned(int node) const { return anyTurned() && index_[std::size_t(node)] >= 0; } ///< it has axes of its own
  bool anyTurned() const { return !axes_.empty(); }                                       ///< any node has
  /// dim x dim, row k = axis of component k; only for turned nodes.
  const double* axes(int node) const
  {
    return axes_.data() + std::size_t(index_[std::size_t(node)]) * std::size_t(dim_) * std::size_t(dim_);
  }
  void turn(int node, const double* axes); ///< gives it these axes, as axes() has them; copied

  /// Components in the nodes' own axes from global components, and back; vectors of numNodes * dim.
  NodalField toLocal(const Vector& global) const;
  NodalField toGlobal(const Vector& local) const; ///< undoes toLocal()

  bool operator==(const Frames& other) const; ///< exactly, nodes turned in the same order

private:
  int dim_, numNodes_;
  std::vector<int> index_; ///< empty: no node is turned
  std::vector<double> axes_;
};

/// A point of an interface seen from one body: the normal displacement of this node is asked for.
struct TraceNormal
{
  int node;         ///< of the body's NodeMap
  Direction normal; ///< n_c
};

/// How a normal displacement depends on dofs: u_N = scale * s + sum others * s' + offset. Scale is 1 unless the normal
/// is oblique to a support's direction at the same node (or points against the axis). Further normals of a node add the
/// dofs of those before.
struct TraceDof
{
  int dof;               ///< that of s, Kept
  double scale;          ///< dimensionless, not zero
  double offset;         ///< a length: the part of u_N that supports prescribe
  SparseRow others = {}; ///< by places in the trace
};

/// A trace normal whose displacement follows from those of other normals of its node, because these have all that
/// supports leave free there: u_N = row u + offset.
struct DependentTrace
{
  int given;           ///< its place in the list of trace normals
  SparseRow row;       ///< by places in DofLayout::trace, of their normal displacements
  double offset = 0.0; ///< a length
};

/// What every dof of a body is. dof = node * dim + component in the node's own axes.
struct DofLayout
{
  Frames frames;                          ///< axes of the components
  std::vector<DofRole> roles;             ///< one per dof
  SparseRow prescribed;                   ///< values of the fixed dofs that are not zero, ascending
  std::vector<TraceDof> trace;            ///< one per trace normal that does not depend on others, in their order
  std::vector<DependentTrace> dependents; ///< the other trace normals, in their order

  void addPrescribed(Vector& u, double factor = 1.0) const; ///< u += factor times them
  std::vector<int> keptDofs() const;                        ///< of `trace`, in its order: the condensed system's
  /// The same axes, the same dofs fixed and kept: K and its factor are the same, whatever the prescribed values.
  bool splitsLike(const DofLayout& other) const;
};

/// Chooses axes so that supports fix dofs and interface normals are dofs. A node may have any number of trace normals,
/// as many as interfaces and corners meet there; their free parts must not vanish (ConstraintSet::freePart). Normals
/// count as dependent when less than 1e-9 of them is new.
DofLayout makeDofLayout(const NodeMap& nodes, const ConstraintSet& constraints, const std::vector<TraceNormal>& traces);

} // namespace ndframe
