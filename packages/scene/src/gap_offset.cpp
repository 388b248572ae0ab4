#include "ndframe/scene/gap_offset.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ndframe/mesh/nearest_point.hpp"

namespace ndframe
{
namespace
{

/// The nodes of one side of a body with their normals and offsets.
struct OffsetSide
{
  const NodeMap& map;
  const std::vector<int>& nodes;
  const std::vector<Direction>& normals;
  Vector along; ///< offset along the normal, per node
};

std::vector<OffsetSide> sidesOf(const Model& model, int body)
{
  const NodeMap& map = model.bodies[std::size_t(body)].nodes;
  std::vector<OffsetSide> sides;
  for (const auto& interface : model.interfaces)
    for (const ContactRole role : bothRoles) {
      if (interface.side(role).body != body)
        continue;
      const bool moves =
          (role == ContactRole::Dirichlet) != model.bodies[std::size_t(interface.neumann().body)].isRigid;
      Vector along(interface.gap.size(), 0.0);
      for (std::size_t i = 0; moves && i < along.size(); ++i) { // what is drawn needs no offset
        const double opening = interface.gap[i] - (interface.drawnGap.empty() ? 0.0 : interface.drawnGap[i]);
        along[i] = -signOf(role) * opening;
      }
      sides.push_back({map, interface.side(role).nodes, interface.normals, std::move(along)});
    }
  return sides;
}

/// Adds a side's offset at its node nearest to the point, weighted with the inverse squared distance.
void addNearest(const NearestPoint& tree, const OffsetSide& side, const double* point, Direction& sum, double& weights)
{
  constexpr double smallest = 1e-300;
  const auto [nearest, squared] = tree.find(point);
  const double weight = 1.0 / std::max(squared, smallest);
  weights += weight;
  for (std::size_t k = 0; k < 3; ++k)
    sum[k] += weight * side.along[nearest] * side.normals[nearest][k];
}

/// Exact on the sides: where two of them meet the offset has both normal parts. Sides that are almost in line with gaps
/// that differ keep the mean.
void setOnSides(const std::vector<OffsetSide>& sides, const NodeMap& map, Vector& offset)
{
  ConstraintSet given(map.dim, 1.0);
  double widest = 0.0;
  for (const auto& side : sides) {
    widest = std::max(widest, largestEntry(side.along));
    for (std::size_t i = 0; i < side.nodes.size(); ++i)
      given.add({side.nodes[i], side.normals[i], side.along[i]});
  }
  constexpr double farOff = 3.0;
  for (const auto& [node, at] : given.nodes()) {
    const double size = std::hypot(at.value[0], at.value[1], at.value[2]);
    if (size > farOff * widest)
      continue;
    for (std::size_t k = 0; k < std::size_t(map.dim); ++k) {
      double& component = offset[std::size_t(node) * std::size_t(map.dim) + k];
      component = 0.0;
      for (std::size_t d = 0; d < std::size_t(at.count); ++d)
        component += at.value[d] * at.direction[d][k];
    }
  }
}

Vector offsetOf(const Model& model, int body)
{
  const NodeMap& map = model.bodies[std::size_t(body)].nodes;
  Vector offset(std::size_t(map.numNodes()) * std::size_t(map.dim), 0.0);
  const auto sides = sidesOf(model, body);
  const bool moves = std::any_of(sides.begin(), sides.end(), [](const auto& side) {
    return std::any_of(side.along.begin(), side.along.end(), [](double value) { return value != 0.0; });
  });
  if (!moves)
    return offset;
  std::vector<NearestPoint> trees;
  for (const auto& side : sides)
    trees.emplace_back(map, side.nodes);
  for (int node = 0; node < map.numNodes(); ++node) {
    Direction sum{};
    double weights = 0.0;
    for (std::size_t s = 0; s < sides.size(); ++s)
      addNearest(trees[s], sides[s], map.point(node).data(), sum, weights);
    for (std::size_t k = 0; k < std::size_t(map.dim); ++k)
      offset[std::size_t(node) * std::size_t(map.dim) + k] = sum[k] / weights;
  }
  setOnSides(sides, map, offset);
  return offset;
}

} // namespace

std::vector<NodalField> gapOffsets(const Model& model)
{
  const bool anyGap = std::any_of(model.interfaces.begin(), model.interfaces.end(), [](const auto& interface) {
    return interface.drawnGap.empty() &&
           std::any_of(interface.gap.begin(), interface.gap.end(), [](double gap) { return gap > 0.0; });
  });
  std::vector<NodalField> offsets;
  for (std::size_t b = 0; anyGap && b < model.bodies.size(); ++b)
    offsets.push_back(atNodes(offsetOf(model, int(b)), model.bodies[b].mesh.dim));
  return offsets;
}

} // namespace ndframe
