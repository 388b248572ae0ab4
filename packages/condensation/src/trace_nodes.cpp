#include "trace_nodes.hpp"

#include <algorithm>
#include <map>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// A body at an interface node.
struct Place
{
  NodeSide side;
  int trace = -1;     ///< its place among the body's traces; -1 where supports hold it
  double along = 1.0; ///< 1 or -1: the normal of all traces at this node over n_c
};
using Places = std::array<Place, 2>;

/// Whether a held side of a node is free at another one: then a coefficient of both would be no obstacle.
bool isHeldAlone(const Places& node, const Places& other)
{
  return (!node[0].side.isFree && other[0].side.isFree) || (!node[1].side.isFree && other[1].side.isFree);
}

class Numbering
{
public:
  Numbering(const Model& model, InterfaceSystem& system) : model_(model), system_(system), bodies_(model.bodies.size())
  {
    system.dim = model.bodies.front().mesh.dim;
    for (const auto& interface : model.interfaces) {
      addSlitEnds(interface);
      for (int i = 0; i < interface.numNodes(); ++i)
        add(interface, i);
    }
    if (model.conditions == ContactConditions::Bernstein)
      chooseBasis();
    system.gap = system.obstacle = ofUnknowns(Vector(system.nodeOfUnknown.size(), 0.0));
    for (std::size_t i = 0; i < system.nodeOfUnknown.size(); ++i)
      describe(i);
  }

  std::vector<BodyTraceNodes> bodies() && { return std::move(bodies_); }

private:
  void add(const InterfaceMesh& interface, int i)
  {
    const int node = int(places_.size());
    gaps_.push_back(interface.gap[std::size_t(i)]);
    const auto sides = model_.sidesAt(interface, i);
    places_.push_back({Place{sides[0]}, Place{sides[1]}});
    if (!model_.carriesContact(interface, i))
      return;
    const bool isObstacle = !sides[0].isFree || !sides[1].isFree;
    for (Place& place : places_.back()) { // an obstacle is met along the free body's normal
      place.along = isObstacle ? signOf((sides[0].isFree ? sides[0] : sides[1]).role) : 1.0;
      if (!place.side.isFree)
        continue;
      auto& body = bodies_[std::size_t(place.side.body)];
      Direction normal = interface.normals[std::size_t(i)];
      for (double& component : normal)
        component *= place.along;
      place.trace = int(body.traces.size());
      body.traces.push_back({place.side.node, normal});
      body.unknowns.push_back(system_.size());
      body.roles.push_back(isObstacle ? ContactRole::Dirichlet : place.side.role);
      body.points.push_back(interface.pointOf(place.side.role, i));
    }
    system_.nodeOfUnknown.push_back(node);
    system_.isObstacle.push_back(isObstacle);
  }

  void addSlitEnds(const InterfaceMesh& interface)
  {
    const auto first = int(places_.size());
    std::map<int, SlitEnd> ends;
    for (std::size_t i = 0; i < interface.facets.size() && interface.touchesItself(); ++i)
      if (const int node = interface.facets[i]; interface.facesItself(node)) {
        SlitEnd& end = ends[node];
        end.node = first + node;
        const auto size = std::size_t(interface.nodesPerFacet());
        NDFRAME_ASSERT(size > 0, "facets have nodes");
        const std::size_t facet = i - i % size;
        for (std::size_t a = facet; a < facet + size; ++a)
          if (!interface.facesItself(interface.facets[a]))
            end.beside.push_back(first + interface.facets[a]);
      }
    for (auto& entry : ends)
      system_.slitEnds.push_back(std::move(entry.second));
  }

  void chooseBasis()
  {
    std::vector<char> isNodal(places_.size(), 0);
    const ContactBasis all(model_.interfaces, isNodal);
    for (int node = 0; node < all.size(); ++node)
      isNodal[std::size_t(node)] =
          std::any_of(all.row(node).begin(), all.row(node).end(), [&](const std::pair<int, double>& entry) {
            return isHeldAlone(places_[std::size_t(node)], places_[std::size_t(entry.first)]);
          });
    system_.basis = std::make_shared<ContactBasis>(model_.interfaces, isNodal);
  }

  SparseRow rowOf(int node) const { return system_.basis ? system_.basis->row(node) : SparseRow{{node, 1.0}}; }

  /// Gap, obstacle and the bodies' coefficients of an unknown.
  void describe(std::size_t unknown)
  {
    const int node = system_.nodeOfUnknown[unknown];
    const SparseRow row = rowOf(node);
    double gap = 0.0, smallest = gaps_[std::size_t(node)];
    for (const auto& [other, share] : row) {
      gap += share * gaps_[std::size_t(other)];
      smallest = std::min(smallest, gaps_[std::size_t(other)]);
    }
    for (std::size_t s = 0; s < 2; ++s) {
      const Place& own = places_[std::size_t(node)][s];
      if (own.side.isFree)
        addCoefficient(own, s, row);
      else
        for (const auto& [other, share] : row)
          system_.obstacle[unknown] += share * own.along * places_[std::size_t(other)][s].side.held;
    }
    // What is open at all nodes is not closed before anything moves: coefficients may lie below a convex gap.
    system_.gap[unknown] = std::max(gap, smallest);
  }

  void addCoefficient(const Place& own, std::size_t side, const SparseRow& row)
  {
    AffineRows& coefficients = bodies_[std::size_t(own.side.body)].coefficients;
    double constant = 0.0;
    SparseRow values;
    for (const auto& [node, share] : row) {
      const Place& other = places_[std::size_t(node)][side];
      if (other.trace >= 0)
        values.emplace_back(other.trace, share * own.along * other.along);
      else
        constant += share * own.along * other.side.held;
    }
    coefficients.rows.push_back(std::move(values));
    coefficients.offset.push_back(constant);
  }

  const Model& model_;
  InterfaceSystem& system_;
  std::vector<BodyTraceNodes> bodies_;
  std::vector<Places> places_; ///< per interface node
  Vector gaps_;                ///< the same
};

/// The normal displacements of all of a body's traces from those that do not depend on others.
AffineRows followed(std::size_t size, const std::vector<DependentTrace>& dependents)
{
  AffineRows values{std::vector<SparseRow>(size), Vector(size, 0.0)};
  for (const DependentTrace& dependent : dependents) {
    values.rows[std::size_t(dependent.given)] = dependent.row;
    values.offset[std::size_t(dependent.given)] = dependent.offset;
  }
  int next = 0;
  for (SparseRow& row : values.rows)
    if (row.empty())
      row = {{next++, 1.0}};
  return values;
}

/// The diagonal first, as inverseOf wants it.
void putFirst(SparseRow& row, int column)
{
  const auto found =
      std::find_if(row.begin(), row.end(), [column](const auto& entry) { return entry.first == column; });
  NDFRAME_ASSERT(found != row.end(), "a value depends on its own node");
  std::rotate(row.begin(), found, found + 1);
}

} // namespace

BodyTraceNodes BodyTraceNodes::without(const std::vector<DependentTrace>& dependents) const
{
  std::vector<char> leaves(traces.size(), 0);
  for (const DependentTrace& dependent : dependents)
    leaves[std::size_t(dependent.given)] = 1;
  BodyTraceNodes rest;
  for (std::size_t i = 0; i < traces.size(); ++i)
    if (!leaves[i]) {
      rest.traces.push_back(traces[i]);
      rest.unknowns.push_back(unknowns[i]);
      rest.roles.push_back(roles[i]);
      rest.points.push_back(points[i]);
    }
  rest.coefficients = coefficients;
  return rest;
}

std::vector<BodyTraceNodes> numberUnknowns(const Model& model, InterfaceSystem& system)
{
  return Numbering(model, system).bodies();
}

BodyTraceMap mapOf(const BodyTraceNodes& nodes, const DofLayout& layout)
{
  AffineRows all = nodes.coefficients.after(followed(nodes.traces.size(), layout.dependents)), own;
  std::vector<char> follows(nodes.traces.size(), 0);
  for (const DependentTrace& dependent : layout.dependents)
    follows[std::size_t(dependent.given)] = 1;
  for (std::size_t i = 0; i < follows.size(); ++i)
    if (!follows[i]) {
      putFirst(all.rows[i], int(own.rows.size()));
      own.rows.push_back(all.rows[i]);
      own.offset.push_back(all.offset[i]);
    }
  AffineRows others;
  BodyTraceMap result{own, TraceMap(layout.trace, own), {}};
  for (const DependentTrace& dependent : layout.dependents) {
    others.rows.push_back(all.rows[std::size_t(dependent.given)]);
    others.offset.push_back(all.offset[std::size_t(dependent.given)]);
  }
  others = others.after(inverseOf(own));
  for (std::size_t d = 0; d < layout.dependents.size(); ++d) {
    const auto given = std::size_t(layout.dependents[d].given);
    result.dependents.push_back({nodes.unknowns[given], nodes.roles[given], others.rows[d], others.offset[d]});
  }
  return result;
}

} // namespace ndframe
