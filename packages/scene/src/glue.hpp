#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "ndframe/mesh/cut_facets.hpp"

namespace ndframe
{

/// Vertices of all parts, one after the other, that become one.
class Glue
{
public:
  explicit Glue(const std::vector<DerivedMesh>& parts)
  {
    for (const DerivedMesh& part : parts) {
      first_.push_back(int(root_.size()));
      root_.resize(root_.size() + std::size_t(part.mesh.numPoints()));
    }
    std::iota(root_.begin(), root_.end(), 0);
  }

  int number(int part, int vertex) const { return first_[std::size_t(part)] + vertex; }
  int root(int number) const
  {
    while (root_[std::size_t(number)] != number)
      number = root_[std::size_t(number)];
    return number;
  }
  /// The one with the smaller number stays where it is.
  void join(int a, int b)
  {
    a = root(a);
    b = root(b);
    root_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

private:
  std::vector<int> first_, root_;
};

} // namespace ndframe
