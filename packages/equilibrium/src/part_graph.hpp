#pragma once

#include "ndframe/equilibrium/body_piece.hpp"
#include "settle_tree.hpp"

namespace ndframe
{

/// The parts of a body that ranks have for themselves (CellTree of their own cells), numbered over all ranks, and how
/// they hang together: a tree for every connected part of the body. The same on all ranks.
class PartGraph
{
public:
  /// Collective.
  PartGraph(const BodyPiece& piece, const CellTree& own, const Comm& comm);

  int size() const { return int(parent_.size()); }
  /// The number of one of this rank's parts.
  int number(std::size_t ownPart) const { return first_ + int(ownPart); }
  bool isOwn(int part) const { return part >= first_ && part < first_ + own_; }
  /// Parts, each after the one that it hangs on.
  const std::vector<int>& order() const { return order_; }
  /// The part that one hangs on; -1 for roots: there is the largest cell of the connected part.
  int parent(int part) const { return parent_[std::size_t(part)]; }
  /// The root of a part's tree.
  int root(int part) const { return root_[std::size_t(part)]; }
  /// The half facet of a part, held by this rank, through which it hands on to its parent: of a part that is own or
  /// whose parent is.
  int exit(int part, const BodyPiece& piece, const CellTree& tree) const;

private:
  struct Joint
  {
    int low, high;     ///< parts
    std::int64_t cell; ///< of `low`: its number in the body
    int facet;         ///< the same, sorted
  };
  void findJoints(const BodyPiece& piece, const CellTree& own, const Comm& comm);
  void hang(int root);

  int first_ = 0, own_ = 0;
  std::vector<Joint> joints_;
  std::vector<int> order_, parent_, root_, joint_; ///< per part, but `order_`
};

} // namespace ndframe
