#pragma once

#include "ndframe/flow/spring.hpp"

namespace ndframe
{

/// Hands on what the nodes of a graph (cells of a body, or sets of cells) lack of balance from node to node until every
/// one has what it needs.
///
/// Nodes are halved by place again and again, and what a half lacks comes from the other one through all links between
/// the two: as a rigid motion of one against the other would load their springs. So what passes through a link is what
/// a compact set of nodes lacks, not a path of them, and levers are as long as the set is. Any flow is admissible; this
/// one is near that of the least energy where what neighbours lack nearly adds up to nothing.
/// Which nodes are halves depends on the graph alone.
class WrenchFlow
{
public:
  struct Link
  {
    std::array<int, 2> node;
    Spring spring;
  };

  WrenchFlow(std::vector<Direction> centres, std::vector<Link> links);

  int size() const { return int(centres_.size()); }
  const std::vector<Link>& links() const { return links_; }
  const Direction& centre(int node) const { return centres_[std::size_t(node)]; }
  int numParts() const { return int(parts_.size()); } ///< that hang together; numbered by their first nodes
  int partOf(int node) const { return partOf_[std::size_t(node)]; }
  int firstOf(int part) const { return parts_[std::size_t(part)].front(); } ///< its first node
  /// lacks: per node, about its centre; a part's add up to nothing. What the first node of every link is to get, and
  /// the second one to give, about the link's centre. What parts lack in all stays in one of their nodes; round-off
  /// does in others.
  std::vector<ForceMoment> through(std::vector<ForceMoment> lacks) const;

private:
  struct Range
  {
    int first, last;
  };
  /// A link as one of its nodes sees it.
  struct Arm
  {
    int link, other;
  };
  class Pass;

  const Arm* begin(int node) const { return arms_.data() + firstArm_[std::size_t(node)]; }
  const Arm* end(int node) const { return arms_.data() + firstArm_[std::size_t(node) + 1]; }

  std::vector<Direction> centres_;
  std::vector<Link> links_;
  std::vector<Arm> arms_; ///< of a node one after the other
  std::vector<int> firstArm_;
  std::vector<std::vector<int>> parts_;
  std::vector<int> partOf_;
};

} // namespace ndframe
