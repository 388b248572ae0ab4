#include "ndframe/assembly/dof_layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

/// A node whose displacement supports or interfaces ask for.
struct AskedNode
{
  int node;
  const ConstraintSet::Node* fixed = nullptr;
  std::vector<int> traces = {};                    ///< of the list of trace normals
  std::vector<Direction> axes = {};                ///< of those that depend on no other
  std::vector<double> fresh = {};                  ///< per trace: how much of it is new; 0: it depends on others
  std::vector<std::pair<int, double>> places = {}; ///< component and sign of the axes
  std::vector<int> known = {};                     ///< places in the trace of the normals so far that have axes
  std::size_t next = 0;                            ///< of the node's traces
};

constexpr double nothingNew = 1e-9; ///< of a unit normal beside those before

/// What supports and the normals before leave of each normal: an axis, or nothing.
void findAxes(AskedNode& asked, const std::vector<TraceNormal>& traces, const ConstraintSet& constraints)
{
  for (const int given : asked.traces) {
    Direction free = constraints.freePart(asked.node, traces[std::size_t(given)].normal);
    NDFRAME_ASSERT(dotProduct(free, free) > 0.0, "the normal displacement of a trace node is prescribed");
    for (const Direction& known : asked.axes) {
      const double along = dotProduct(free, known);
      for (std::size_t i = 0; i < 3; ++i)
        free[i] -= along * known[i];
    }
    const double length = std::sqrt(dotProduct(free, free));
    asked.fresh.push_back(length > nothingNew ? length : 0.0);
    if (asked.fresh.back() == 0.0)
      continue;
    for (double& component : free)
      component /= length;
    asked.axes.push_back(free);
  }
}

/// Fixes and keeps the dofs of a node.
void layOutNode(DofLayout& layout, int dim, AskedNode& asked)
{
  std::vector<Direction> directions;
  const int numFixed = asked.fixed == nullptr ? 0 : asked.fixed->count;
  for (int k = 0; k < numFixed; ++k)
    directions.push_back(asked.fixed->direction[std::size_t(k)]);
  directions.insert(directions.end(), asked.axes.begin(), asked.axes.end());
  const auto places = placeDirections(layout.frames, dim, asked.node, directions);
  const auto dof = [&](std::size_t k) {
    return std::size_t(asked.node) * std::size_t(dim) + std::size_t(places[k].first);
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    layout.roles[dof(k)] = int(k) < numFixed ? DofRole::Fixed : DofRole::Kept;
    if (int(k) < numFixed)
      if (const double value = places[k].second * asked.fixed->value[k]; value != 0.0)
        layout.prescribed.emplace_back(int(dof(k)), value);
  }
  asked.places.assign(places.begin() + numFixed, places.end());
}

/// The nodes of supports and traces, and the place of each trace normal's node among them.
std::vector<AskedNode> gatherNodes(const ConstraintSet& constraints, const std::vector<TraceNormal>& traces,
                                   std::vector<int>& nodeOfTrace)
{
  std::map<int, int> numbers;
  std::vector<AskedNode> nodes;
  const auto number = [&](int node) {
    const auto [found, isNew] = numbers.emplace(node, int(nodes.size()));
    if (isNew)
      nodes.push_back({node});
    return found->second;
  };
  for (std::size_t given = 0; given < traces.size(); ++given) {
    nodeOfTrace.push_back(number(traces[given].node));
    nodes[std::size_t(nodeOfTrace.back())].traces.push_back(int(given));
  }
  for (const auto& [node, fixed] : constraints.nodes())
    nodes[std::size_t(number(node))].fixed = &fixed;
  return nodes;
}

/// u_N = row u' + offset in terms of the normals before, from u_N = sum along s + held: each s = (u' - others s - b) /
/// a.
DependentTrace dependentOn(const DofLayout& layout, int given, const std::vector<int>& known, Vector along, double held)
{
  DependentTrace dependent{given, {}, held};
  for (std::size_t k = known.size(); k-- > 0;) {
    const TraceDof& dof = layout.trace[std::size_t(known[k])];
    const double share = along[k] / dof.scale;
    dependent.offset -= share * dof.offset;
    for (const auto& [place, value] : dof.others)
      along[std::size_t(std::find(known.begin(), known.end(), place) - known.begin())] -= share * value;
    dependent.row.emplace_back(known[k], share);
  }
  return dependent;
}

void addTrace(DofLayout& layout, int dim, AskedNode& asked, const TraceNormal& trace, double held)
{
  const std::size_t own = asked.next++, before = asked.known.size();
  Vector along;
  for (std::size_t k = 0; k < before; ++k)
    along.push_back(asked.places[k].second * dotProduct(asked.axes[k], trace.normal));
  if (asked.fresh[own] == 0.0) {
    layout.dependents.push_back(dependentOn(layout, asked.traces[own], asked.known, along, held));
    return;
  }
  const auto [component, sign] = asked.places[before];
  TraceDof dof{trace.node * dim + component, sign * asked.fresh[own], held, {}};
  for (std::size_t k = 0; k < before; ++k)
    dof.others.emplace_back(asked.known[k], along[k]);
  asked.known.push_back(int(layout.trace.size()));
  layout.trace.push_back(std::move(dof));
}

} // namespace

void Frames::turn(int node, const double* axes)
{
  index_.resize(std::size_t(numNodes_), -1);
  index_[std::size_t(node)] = int(axes_.size()) / (dim_ * dim_);
  axes_.insert(axes_.end(), axes, axes + std::ptrdiff_t(dim_) * dim_);
}

NodalField Frames::toLocal(const Vector& global) const
{
  Vector local = global;
  for (std::size_t node = 0; anyTurned() && node < index_.size(); ++node)
    if (isTurned(int(node)))
      for (int k = 0; k < dim_; ++k) {
        double& value = local[node * std::size_t(dim_) + std::size_t(k)] = 0.0;
        for (int i = 0; i < dim_; ++i)
          value += axes(int(node))[k * dim_ + i] * global[node * std::size_t(dim_) + std::size_t(i)];
      }
  return atNodes(std::move(local), dim_);
}

NodalField Frames::toGlobal(const Vector& local) const
{
  Vector global = local;
  for (std::size_t node = 0; anyTurned() && node < index_.size(); ++node)
    if (isTurned(int(node)))
      for (int i = 0; i < dim_; ++i) {
        double& value = global[node * std::size_t(dim_) + std::size_t(i)] = 0.0;
        for (int k = 0; k < dim_; ++k)
          value += axes(int(node))[k * dim_ + i] * local[node * std::size_t(dim_) + std::size_t(k)];
      }
  return atNodes(std::move(global), dim_);
}

bool Frames::operator==(const Frames& other) const
{
  return dim_ == other.dim_ && index_ == other.index_ && axes_ == other.axes_;
}

bool DofLayout::splitsLike(const DofLayout& other) const
{
  return frames == other.frames && roles == other.roles && keptDofs() == other.keptDofs();
}

void DofLayout::addPrescribed(Vector& u, double factor) const
{
  for (const auto& [dof, value] : prescribed)
    u[std::size_t(dof)] += factor * value;
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
  DofLayout layout{Frames(nodes.dim, nodes.numNodes()), std::vector<DofRole>(numDofs, DofRole::Interior), {}, {}, {}};
  std::vector<int> nodeOfTrace;
  std::vector<AskedNode> asked = gatherNodes(constraints, traces, nodeOfTrace);
  for (AskedNode& node : asked) {
    findAxes(node, traces, constraints);
    layOutNode(layout, nodes.dim, node);
  }
  std::sort(layout.prescribed.begin(), layout.prescribed.end());
  for (std::size_t given = 0; given < traces.size(); ++given)
    addTrace(layout, nodes.dim, asked[std::size_t(nodeOfTrace[given])], traces[given],
             constraints.heldValue(traces[given].node, traces[given].normal));
  return layout;
}

} // namespace ndframe
