#pragma once

#include <array>
#include <limits>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Finds the cell of a plane mesh that a point lies in or is nearest to, in a tree of boxes: O(log cells) each,
/// O(cells log cells) to build, whatever the sizes of cells.
class CellLocator
{
public:
  /// The mesh must outlive this.
  explicit CellLocator(const Mesh& mesh);

  /// The cell that is nearest to a point.
  struct Place
  {
    double squaredDistance = std::numeric_limits<double>::infinity(); ///< of the point from the cell
    int cell = -1;                                                    ///< -1 for a point that is not finite
    std::array<double, 3> weights{}; ///< of the cell's vertices, for its point that is nearest; their sum is 1
  };
  Place find(const std::array<double, 2>& point) const; ///< distance 0 for points in the mesh

private:
  struct Box
  {
    std::array<double, 2> lower, upper;
  };
  /// A leaf with cells order_[begin, end), or a branch whose children are the node after it and `right`.
  struct Node
  {
    Box box;
    int begin, end, right;
  };

  int build(int begin, int end);
  Box boxOf(int begin, int end) const;
  static double squaredDistance(const Box& box, const std::array<double, 2>& point);
  void search(int node, const std::array<double, 2>& point, Place& nearest) const;
  void compare(int cell, const std::array<double, 2>& point, Place& nearest) const;

  const Mesh& mesh_;
  std::vector<int> order_; ///< cells
  std::vector<Node> nodes_;
};

} // namespace ndframe
