#include "ndframe/assembly/constraint_set.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ndframe
{
namespace
{
/// Directions closer than this (sine of the angle) are one direction.
constexpr double parallel = 1e-7;
/// Two supports agree at a node when their displacements differ by less than this, relative to the body's size.
constexpr double agreement = 1e-12;
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

ConstraintSet collectConstraints(const std::vector<std::unique_ptr<Support>>& supports, const Mesh& mesh,
                                 const NodeMap& nodes)
{
  ConstraintSet set(mesh.dim, diameter(mesh));
  Diagnostics diagnostics;
  for (const auto& support : supports)
    for (const auto& constraint : support->constraints(mesh, nodes))
      if (!set.add(constraint)) {
        const double* x = nodes.point(constraint.node);
        diagnostics.add(support->params().mistake(
            "", fmt::format(
                    "contradicts another support at ({:g}, {:g}{}), which prescribes a different displacement there.",
                    x[0], x[1], mesh.dim == 3 ? fmt::format(", {:g}", x[2]) : "")));
        break;
      }
  diagnostics.throwIfAny();
  return set;
}

} // namespace ndframe
