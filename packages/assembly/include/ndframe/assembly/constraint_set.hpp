#pragma once

#include <array>
#include <map>
#include <vector>

#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{

/// The prescribed displacements of a body, node by node, reduced to orthonormal directions.
class ConstraintSet
{
public:
  /// What is prescribed at a node: u . direction[k] = value[k] (a length) for k < count, directions orthonormal.
  struct Node
  {
    int count = 0;                        ///< independent directions
    std::array<Direction, 3> direction{}; ///< global axes
    std::array<double, 3> value{};        ///< one per direction; zero beyond `count`
  };

  /// `lengthScale`: what a displacement is compared with when two supports meet at a node (a body's size).
  ConstraintSet(int dim, double lengthScale) : dim_(dim), lengthScale_(lengthScale) {}

  /// False when the constraint contradicts those already there.
  bool add(const NodeConstraint& constraint);

  /// What is prescribed at a node from now on; nothing where there are no directions.
  void set(int node, const Node& given);

  /// The part of a direction that stays free at a node (the direction minus its prescribed part).
  Direction freePart(int node, const Direction& direction) const;

  /// What the prescribed displacements at a node contribute along a direction.
  double heldValue(int node, const Direction& direction) const;

  const std::map<int, Node>& nodes() const { return nodes_; } ///< by node number; those with constraints
  int dim() const { return dim_; }                            ///< of space

private:
  int dim_;
  double lengthScale_;
  std::map<int, Node> nodes_;
};

/// The constraints of all supports of a body; supports that contradict each other at a node are the user's mistake.
ConstraintSet collectConstraints(const std::vector<std::unique_ptr<Support>>& supports, const Mesh& mesh,
                                 const NodeMap& nodes);

/// a . b
double dotProduct(const Direction& a, const Direction& b);

} // namespace ndframe
