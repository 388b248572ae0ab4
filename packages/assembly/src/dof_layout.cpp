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

/// Another normal of a node in the plane whose first one has the place `first` in the trace, the second one `second`
/// (-1: none yet).
class FurtherNormal
{
public:
  FurtherNormal(DofLayout& layout, const TraceNormal& trace, int first, const ConstraintSet& constraints)
      : layout_(layout), first_(first), component_(layout.trace[std::size_t(first)].dof - 2 * trace.node),
        alongFirst_(along(trace, component_)), alongOther_(along(trace, 1 - component_)),
        offset_(constraints.heldValue(trace.node, trace.normal)), dof_(2 * trace.node + 1 - component_),
        isHeld_(layout.roles[std::size_t(dof_)] == DofRole::Fixed)
  {}

  bool isDependent(int second) const { return isHeld_ || second >= 0 || std::abs(alongOther_) <= parallel; }

  /// The other dof of the node becomes a kept one.
  void add()
  {
    layout_.roles[std::size_t(dof_)] = DofRole::Kept;
    layout_.trace.push_back({dof_, alongOther_, 0.0, first_, alongFirst_});
  }

  /// From the dofs' values in terms of the normals before: s_1 = (u_1 - b_1) / a_1, s_2 = (u_2 - c_2 s_1) / a_2.
  void addDependent(int given, int second)
  {
    const TraceDof& first = layout_.trace[std::size_t(first_)];
    DependentTrace dependent{given, first_, alongFirst_ / first.scale};
    if (!isHeld_ && second >= 0 && std::abs(alongOther_) > parallel) {
      const TraceDof& other = layout_.trace[std::size_t(second)];
      dependent.other = second;
      dependent.otherShare = alongOther_ / other.scale;
      dependent.share -= dependent.otherShare * other.along / first.scale;
    }
    dependent.offset = isHeld_ ? offset_ - dependent.share * first.offset : 0.0;
    layout_.dependents.push_back(dependent);
  }

private:
  double along(const TraceNormal& trace, int axis) const
  {
    if (!layout_.frames.isTurned(trace.node))
      return trace.normal[std::size_t(axis)];
    const double* axes = layout_.frames.axes(trace.node) + std::ptrdiff_t(2) * axis;
    return axes[0] * trace.normal[0] + axes[1] * trace.normal[1];
  }

  static constexpr double parallel = 1e-9;

  DofLayout& layout_;
  int first_, component_;
  double alongFirst_, alongOther_, offset_;
  int dof_;
  bool isHeld_;
};

void addFurtherNormal(DofLayout& layout, const TraceNormal& trace, int given, int first, int& second,
                      const ConstraintSet& constraints)
{
  FurtherNormal normal(layout, trace, first, constraints);
  if (normal.isDependent(second))
    return normal.addDependent(given, second);
  second = int(layout.trace.size());
  normal.add();
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
  DofLayout layout{Frames(nodes.dim, nodes.numNodes()),
                   std::vector<DofRole>(numDofs, DofRole::Interior),
                   Vector(numDofs, 0.0),
                   {},
                   {}};
  const std::vector<int> none(std::size_t(nodes.numNodes()), -1);
  std::vector<int> place = none, second = none; // of a node's first two normals in the trace
  for (std::size_t given = 0; given < traces.size(); ++given) {
    const TraceNormal& trace = traces[given];
    int& first = place[std::size_t(trace.node)];
    if (first >= 0) {
      NDFRAME_ASSERT(nodes.dim == 2, "a node in space has one trace normal");
      addFurtherNormal(layout, trace, int(given), first, second[std::size_t(trace.node)], constraints);
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
