#pragma once

#include <cstddef>
#include <vector>

namespace ndframe
{

/// The graph of some nodes of a matrix, without loops: vertex v is the node nodes[v].
struct NodeGraph
{
  std::vector<int> nodes;
  std::vector<int> starts, neighbours; ///< vertices next to v: neighbours[starts[v]] ... neighbours[starts[v + 1] - 1]
  std::vector<int> weights;            ///< of the vertices; empty: all 1

  /// What a range-based for needs.
  struct Vertices
  {
    const int* first;
    const int* last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };

  int size() const { return int(nodes.size()); }
  int degree(int v) const { return starts[std::size_t(v) + 1] - starts[std::size_t(v)]; }
  Vertices near(int v) const
  {
    return {neighbours.data() + starts[std::size_t(v)], neighbours.data() + starts[std::size_t(v) + 1]};
  }
};

} // namespace ndframe
