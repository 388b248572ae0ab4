#include "ndframe/assembly/constraint_set.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ndframe
{
namespace
{
/// Directions closer than this (sine of the angle) are one direction: the normals of two sides on one line differ by
/// the rounding of a mesh file's coordinates.
constexpr double parallel = 1e-5;
/// Two supports agree at a node when their displacements differ by less than this, relative to the body's size.
constexpr double agreement = 1e-12;

/// The supports before `last` that hold a node, by their places in the deck.
std::string heldByOthers(const std::vector<std::unique_ptr<Support>>& supports, std::size_t last, const Mesh& mesh,
                         const NodeMap& nodes, int node)
{
  std::vector<std::string> places;
  for (std::size_t s = 0; s < last; ++s) {
    const auto constraints = supports[s]->constraints(mesh, nodes);
    if (std::any_of(constraints.begin(), constraints.end(), [node](const auto& c) { return c.node == node; }))
      places.push_back(fmt::format("{} ({})", supports[s]->params().path(), supports[s]->description()));
  }
  return fmt::format("{}", fmt::join(places, " and "));
}

} // namespace

double dotProduct(const Direction& a, const Direction& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool ConstraintSet::add(const NodeConstraint& constraint)
{
  Node& node = nodes_[constraint.node];
  Direction rest = constraint.direction;
  double value = constraint.value;
  for (int k = 0; k < node.count; ++k) {
    const Direction& known = node.direction[std::size_t(k)];
    const double along = dotProduct(constraint.direction, known);
    for (std::size_t i = 0; i < 3; ++i)
      rest[i] -= along * known[i];
    value -= along * node.value[std::size_t(k)];
  }
  const double length = std::sqrt(dotProduct(rest, rest));
  if (length < parallel)
    return std::abs(value) <= agreement * std::max(lengthScale_, std::abs(constraint.value));
  for (double& component : rest)
    component /= length;
  node.direction[std::size_t(node.count)] = rest;
  node.value[std::size_t(node.count)] = value / length;
  ++node.count;
  return true;
}

void ConstraintSet::set(int node, const Node& given)
{
  if (given.count > 0)
    nodes_[node] = given;
  else
    nodes_.erase(node);
}

Direction ConstraintSet::freePart(int node, const Direction& direction) const
{
  Direction rest = direction;
  const auto found = nodes_.find(node);
  if (found == nodes_.end())
    return rest;
  for (int k = 0; k < found->second.count; ++k) {
    const Direction& known = found->second.direction[std::size_t(k)];
    const double along = dotProduct(direction, known);
    for (std::size_t i = 0; i < 3; ++i)
      rest[i] -= along * known[i];
  }
  if (dotProduct(rest, rest) < parallel * parallel)
    return {};
  return rest;
}

double ConstraintSet::heldValue(int node, const Direction& direction) const
{
  double value = 0.0;
  const auto found = nodes_.find(node);
  for (int k = 0; found != nodes_.end() && k < found->second.count; ++k)
    value += dotProduct(direction, found->second.direction[std::size_t(k)]) * found->second.value[std::size_t(k)];
  return value;
}

ConstraintSet collectConstraints(const std::vector<std::unique_ptr<Support>>& supports, const Mesh& mesh,
                                 const NodeMap& nodes)
{
  ConstraintSet set(mesh.dim, diameter(mesh));
  Diagnostics diagnostics;
  for (std::size_t s = 0; s < supports.size(); ++s) {
    int clash = -1; // one point per support tells enough
    for (const auto& constraint : supports[s]->constraints(mesh, nodes))
      if (!set.add(constraint) && clash < 0)
        clash = constraint.node;
    if (clash >= 0)
      diagnostics.add(supports[s]->params().mistake(
          "",
          fmt::format("contradicts {} at {}: another displacement is prescribed there; leave the point out of one "
                      "of them (split the side) or make them agree.",
                      heldByOthers(supports, s, mesh, nodes, clash), pointText(nodes.point(clash).data(), mesh.dim))));
  }
  diagnostics.throwIfAny();
  return set;
}

} // namespace ndframe
