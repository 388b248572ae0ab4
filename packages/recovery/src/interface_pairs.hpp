#pragma once

#include <map>

#include "ndframe/recovery/gap_bound.hpp"
#include "node_stiffness.hpp"

namespace ndframe
{

/// A facet's node: number 0, 1 the vertices, 2 the middle.
struct Corner
{
  std::size_t facet;
  std::size_t number;
};

/// The two bodies at one interface node.
struct Pair
{
  std::array<std::size_t, 2> body{};
  std::array<int, 2> node{};
  std::vector<Corner> corners; ///< one facet for a middle, the facets of a vertex

  bool isMiddle() const { return corners.front().number == 2; }
};

/// How much an interface node's bodies give way along the mean normal, the stiffer one less: for a force of one between
/// them they move apart by `move`.
struct Compliance
{
  std::array<Direction, 2> move{};
  /// What the opening along a facet's normal gains.
  double gain(const Direction& normal) const { return dotProduct(move[1], normal) - dotProduct(move[0], normal); }
};

/// The nodes of all interfaces as pairs of nodes that move against each other.
class InterfacePairs
{
public:
  /// All arguments must outlive it. displacement: per body, global axes.
  InterfacePairs(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
                 const std::vector<ContactFacet>& facets, const GapBound& gap, const std::vector<Vector>& displacement);

  const std::map<int, Pair>& all() const { return pairs_; } ///< by interface node
  std::size_t numBodies() const { return bodies_.size(); }
  /// Largest displacement or gap on the interfaces.
  double size() const { return size_; }

  /// How much the jump's Bernstein coefficient is above the gap's.
  double excess(const Corner& corner) const;
  Compliance compliance(const Pair& pair);
  const NodeStiffness& stiffness(std::size_t body);

private:
  const std::vector<const BodyModel*>& bodies_;
  const std::vector<const ConstraintSet*>& constraints_;
  const std::vector<ContactFacet>& facets_;
  const GapBound& gap_;
  const std::vector<Vector>& displacement_;
  std::map<int, Pair> pairs_;
  double size_ = 0.0;
  std::vector<NodeStiffness> stiffness_; ///< per body, found when first needed
};

} // namespace ndframe
