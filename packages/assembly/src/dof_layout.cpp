#include "ndframe/assembly/dof_layout.hpp"

#include <cmath>
#include <utility>

namespace ndframe
{
namespace
{

constexpr double aligned = 1e-14; ///< a unit vector that leaves an axis by less than this lies on it

/// The axis (0, 1, 2) that a unit vector lies on, or -1.
int axisOf(const Direction& d)
{
  for (int k = 0; k < 3; ++k)
    if (std::hypot(d[std::size_t((k + 1) % 3)], d[std::size_t((k + 2) % 3)]) < aligned)
      return k;
  return -1;
}

/// Completes orthonormal directions to a basis of the space (dim rows).
std::vector<Direction> completeBasis(std::vector<Direction> basis, int dim)
{
  while (int(basis.size()) < dim) {
    Direction best{};
    double longest = 0.0;
    for (int k = 0; k < dim; ++k) {
      Direction rest{};
      rest[std::size_t(k)] = 1.0;
      for (const auto& known : basis) {
        const double along = known[std::size_t(k)];
        for (std::size_t i = 0; i < 3; ++i)
          rest[i] -= along * known[i];
      }
      const double length = std::sqrt(dotProduct(rest, rest));
      if (length > longest) {
        longest = length;
        for (std::size_t i = 0; i < 3; ++i)
          best[i] = rest[i] / length;
      }
    }
    basis.push_back(best);
  }
  return basis;
}

/// Component and sign of each direction at a node; turns the node's axes where they are not all along x, y, z.
std::vector<std::pair<int, double>> placeDirections(Frames& frames, int dim, int node,
                                                    const std::vector<Direction>& given)
{
  std::vector<std::pair<int, double>> places;
  for (const auto& direction : given)
    if (const int axis = axisOf(direction); axis >= 0)
      places.emplace_back(axis, direction[std::size_t(axis)]);
  if (places.size() == given.size())
    return places;
  places.clear();
  double axes[9];
  const auto basis = completeBasis(given, dim);
  for (int k = 0; k < dim; ++k)
    for (int i = 0; i < dim; ++i)
      axes[k * dim + i] = basis[std::size_t(k)][std::size_t(i)];
  frames.turn(node, axes);
  for (int k = 0; k < int(given.size()); ++k)
    places.emplace_back(k, 1.0);
  return places;
}

void layOutNode(DofLayout& layout, int dim, int node, const ConstraintSet::Node* fixed, const TraceNormal* trace,
                const ConstraintSet& constraints)
{
  std::vector<Direction> directions;
  const int numFixed = fixed == nullptr ? 0 : fixed->count;
  for (int k = 0; k < numFixed; ++k)
    directions.push_back(fixed->direction[std::size_t(k)]);
  double scale = 1.0, offset = 0.0;
  if (trace != nullptr) {
    Direction free = constraints.freePart(node, trace->normal);
    scale = std::sqrt(dotProduct(free, free));
    NDFRAME_ASSERT(scale > 0.0, "the normal displacement of a trace node is prescribed");
    for (double& component : free)
      component /= scale;
    directions.push_back(free);
    offset = constraints.heldValue(node, trace->normal);
  }
  const auto places = placeDirections(layout.frames, dim, node, directions);
  for (int k = 0; k < numFixed; ++k) {
    const auto [component, sign] = places[std::size_t(k)];
    const auto dof = std::size_t(node) * std::size_t(dim) + std::size_t(component);
    layout.roles[dof] = DofRole::Fixed;
    layout.prescribed[dof] = sign * fixed->value[std::size_t(k)];
  }
  if (trace != nullptr) {
    const auto [component, sign] = places.back();
    layout.roles[std::size_t(node) * std::size_t(dim) + std::size_t(component)] = DofRole::Kept;
    layout.trace.push_back({node * dim + component, sign * scale, offset});
  }
}

/// The second normal of a node, whose first one has the place `first` in the trace: what it has along that one's dof,
/// and the other dof of the node.
void addSecondNormal(DofLayout& layout, const TraceNormal& trace, int first, const ConstraintSet& constraints)
{
  NDFRAME_ASSERT(constraints.nodes().count(trace.node) == 0, "a node with two trace normals has no supports");
  const int component = layout.trace[std::size_t(first)].dof - 2 * trace.node, other = 1 - component;
  const auto along = [&](int axis) {
    if (!layout.frames.isTurned(trace.node))
      return trace.normal[std::size_t(axis)];
    const double* axes = layout.frames.axes(trace.node) + std::ptrdiff_t(2) * axis;
    return axes[0] * trace.normal[0] + axes[1] * trace.normal[1];
  };
  const int dof = 2 * trace.node + other;
  NDFRAME_ASSERT(std::abs(along(other)) > aligned && layout.roles[std::size_t(dof)] == DofRole::Interior,
                 "two trace normals of a node are parallel, or a node has three");
  layout.roles[std::size_t(dof)] = DofRole::Kept;
  layout.trace.push_back({dof, along(other), 0.0, first, along(component)});
}

} // namespace

void Frames::turn(int node, const double* axes)
{
  index_[std::size_t(node)] = int(axes_.size()) / (dim_ * dim_);
  axes_.insert(axes_.end(), axes, axes + std::ptrdiff_t(dim_) * dim_);
}

Vector Frames::toLocal(const Vector& global) const
{
  Vector local = global;
  for (std::size_t node = 0; anyTurned() && node < index_.size(); ++node)
    if (isTurned(int(node)))
      for (int k = 0; k < dim_; ++k) {
        double& value = local[node * std::size_t(dim_) + std::size_t(k)] = 0.0;
        for (int i = 0; i < dim_; ++i)
          value += axes(int(node))[k * dim_ + i] * global[node * std::size_t(dim_) + std::size_t(i)];
      }
  return local;
}

Vector Frames::toGlobal(const Vector& local) const
{
  Vector global = local;
  for (std::size_t node = 0; anyTurned() && node < index_.size(); ++node)
    if (isTurned(int(node)))
      for (int i = 0; i < dim_; ++i) {
        double& value = global[node * std::size_t(dim_) + std::size_t(i)] = 0.0;
        for (int k = 0; k < dim_; ++k)
          value += axes(int(node))[k * dim_ + i] * local[node * std::size_t(dim_) + std::size_t(k)];
      }
  return global;
}

bool Frames::operator==(const Frames& other) const
{
  return dim_ == other.dim_ && index_ == other.index_ && axes_ == other.axes_;
}

bool DofLayout::splitsLike(const DofLayout& other) const
{
  return frames == other.frames && roles == other.roles && keptDofs() == other.keptDofs();
}

std::vector<int> DofLayout::keptDofs() const
{
  std::vector<int> kept;
  kept.reserve(trace.size());
  for (const auto& t : trace)
    kept.push_back(t.dof);
  return kept;
}

DofLayout makeDofLayout(const NodeMap& nodes, const ConstraintSet& constraints, const std::vector<TraceNormal>& traces)
{
  const auto numDofs = std::size_t(nodes.numNodes()) * std::size_t(nodes.dim);
  DofLayout layout{
      Frames(nodes.dim, nodes.numNodes()), std::vector<DofRole>(numDofs, DofRole::Interior), Vector(numDofs, 0.0), {}};
  std::vector<int> place(std::size_t(nodes.numNodes()), -1); // of a node's first normal in the trace
  for (const auto& trace : traces) {
    int& first = place[std::size_t(trace.node)];
    if (first >= 0) {
      NDFRAME_ASSERT(nodes.dim == 2, "a node in space has one trace normal");
      addSecondNormal(layout, trace, first, constraints);
      continue;
    }
    first = int(layout.trace.size());
    const auto fixed = constraints.nodes().find(trace.node);
    layOutNode(layout, nodes.dim, trace.node, fixed == constraints.nodes().end() ? nullptr : &fixed->second, &trace,
               constraints);
  }
  for (const auto& [node, fixed] : constraints.nodes())
    if (place[std::size_t(node)] < 0)
      layOutNode(layout, nodes.dim, node, &fixed, nullptr, constraints);
  return layout;
}

} // namespace ndframe
