#pragma once

#include <map>

#include "ndframe/admissibility/gap_bound.hpp"
#include "ndframe/admissibility/jump_coefficients.hpp"
#include "node_stiffness.hpp"

namespace ndframe
{

/// A patch's node: number 0, 1 (in space 2) the vertices, then the middles of its edges.
struct Corner
{
  std::size_t patch;
  std::size_t number;
};

/// The two bodies at one interface node.
struct Pair
{
  std::array<std::size_t, 2> body{};
  std::array<int, 2> node{};
  std::vector<Corner> corners; ///< the patches of an edge's middle, the patches of a vertex
  bool isMiddle = false;
};

/// How much an interface node's bodies give way along the mean normal, the stiffer one less: for a force of one between
/// them they move apart by `move`.
struct Compliance
{
  std::array<Direction, 2> move{};
  /// How much  weight . (u1 - u2)  falls.
  double gain(const Direction& weight) const { return dotProduct(move[1], weight) - dotProduct(move[0], weight); }
};

/// The nodes of all interfaces as pairs of nodes that move against each other.
class InterfacePairs
{
public:
  /// All arguments must outlive it. displacement: per body, global axes.
  InterfacePairs(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
                 const std::vector<ContactPatch>& patches, const GapBound& gap,
                 const std::vector<NodalField>& displacement);

  const std::map<int, Pair>& all() const { return pairs_; } ///< by interface node
  /// Whether a node of the pair belongs to another pair, too: interfaces meet there, and what opens one may close
  /// another.
  bool isShared(const Pair& pair) const;
  /// Whether any is.
  bool areShared() const { return areShared_; }
  std::size_t numBodies() const { return bodies_.size(); }
  /// Largest displacement or gap on the interfaces.
  double size() const { return size_; }

  JumpCoefficients coefficients(std::size_t patch) const;
  /// The coefficients (of its patch's jump) that a corner decides: its own one at a vertex, the inner ones in the
  /// middle.
  std::vector<std::size_t> decided(const Corner& corner) const;
  /// How much a Bernstein coefficient of a patch's jump is above the gap's.
  double excess(std::size_t patch, std::size_t coefficient) const;
  Compliance compliance(const Pair& pair);
  const NodeStiffness& stiffness(std::size_t body);

private:
  const std::vector<const BodyModel*>& bodies_;
  const std::vector<const ConstraintSet*>& constraints_;
  const std::vector<ContactPatch>& patches_;
  const GapBound& gap_;
  const std::vector<NodalField>& displacement_;
  std::map<int, Pair> pairs_;
  std::vector<std::map<int, int>> uses_; ///< per body and node: pairs
  bool areShared_ = false;
  double size_ = 0.0;
  std::vector<NodeStiffness> stiffness_; ///< per body, found when first needed
};

} // namespace ndframe
