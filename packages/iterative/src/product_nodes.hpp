#pragma once

#include "ndframe/iterative/linear_level.hpp"

namespace ndframe
{

/// What P and the roles say of the nodes that the rows of P^T K P of own vertices speak of: own nodes, and those that
/// the rows of other ranks have as columns.
class ProductNodes
{
public:
  /// received: nodes of rows and columns that came from other ranks. Collective.
  ProductNodes(const RankProblem& problem, const LinearInterpolation& P, const IndexMap& received, const Comm& comm);

  const IndexMap& nodes() const { return nodes_; }       ///< all of them
  const IndexMap& vertices() const { return vertices_; } ///< that they interpolate
  /// The ends of the edge of a node, held numbers of vertices; a vertex is both.
  const std::array<int, 2>& ends(int node) const { return ends_[std::size_t(node)]; }
  bool isFree(int node) const { return (flags_[std::size_t(node)] & allHeld) == 0; } ///< all its dofs are interior
  bool isInterior(int node, int component) const { return (flags_[std::size_t(node)] >> component & 1) == 0; }
  /// As of LinearInterpolation.
  const double* blocks(int node) const
  {
    const int place = turned_.empty() ? -1 : turned_[std::size_t(node)];
    return place < 0 ? nullptr : blocks_.data() + std::size_t(place) * blocksSize_;
  }

private:
  using Global = IndexMap::Global;
  static constexpr int allHeld = 7, isTurned = 8;

  Vector factsOfAll(const RankProblem& problem, const LinearInterpolation& P, bool anyTurned, const Comm& comm) const;
  void number(const LinearInterpolation& P, const std::vector<std::array<Global, 2>>& ghostEnds);

  IndexMap nodes_, vertices_;
  std::vector<unsigned char> flags_; ///< per node: bit i, its component i is no interior dof; isTurned
  std::vector<std::array<int, 2>> ends_;
  std::size_t blocksSize_;
  std::vector<int> turned_;
  std::vector<double> blocks_;
};

} // namespace ndframe
