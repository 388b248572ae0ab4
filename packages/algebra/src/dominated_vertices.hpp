#pragma once

#include "node_graph.hpp"

namespace ndframe
{

/// Vertices that take their place in an elimination order from others.
///
/// A vertex is dominated by a neighbour, its host, that has more neighbours, all of its own among them. Eliminated just
/// before its host it fills nothing that the host would not fill, and where the rest of the graph falls apart it joins
/// no two parts: whoever is near it is near its host. The midside nodes of quadratic elements are dominated by the
/// vertices of their edge: three quarters of a triangle mesh's nodes, seven eighths of a tetrahedron mesh's. Linear
/// elements have next to none.
///
/// Related: the compression of indistinguishable vertices (Ashcraft 1995) and the data reductions for nested dissection
/// of Ost, Schulz and Strash (2021). Measured in docs/performance.md.
class DominatedVertices
{
public:
  /// Cost: the sum over the vertices of the degrees of their neighbours at most.
  explicit DominatedVertices(const NodeGraph& graph);

  /// The graph without them; its `nodes` are the vertices of `graph`, a vertex weighs itself and all that it hosts.
  NodeGraph rest(const NodeGraph& graph) const;

  /// Vertices of `rest` in some order -> all vertices, each dominated one just before the first of its hosts.
  std::vector<int> insertedInto(const std::vector<int>& restInOrder) const;

private:
  struct Pair
  {
    int vertex, host;
  };

  std::vector<char> isDominated_;
  std::vector<Pair> pairs_; ///< hosts are not dominated themselves
};

} // namespace ndframe
