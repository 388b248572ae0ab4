#pragma once

#include <array>
#include <limits>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Finds the cell that a point lies in or is nearest to, in a tree of boxes: O(log cells) each, O(cells log cells) to
/// build, whatever the sizes of cells. In the plane third coordinates are not looked at.
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
    std::array<double, 4> weights{}; ///< of the cell's vertices, for its point that is nearest; their sum is 1
  };
  Place find(const std::array<double, 3>& point) const; ///< distance 0 for points in the mesh

private:
  struct Box
  {
    std::array<double, 3> lower, upper; ///< the third coordinates are 0 in the plane
  };
  /// A leaf with cells order_[begin, end), or a branch whose children are the node after it and `right`.
  struct Node
  {
    Box box;
    int begin, end, right;
  };

  int build(int begin, int end);
  Box boxOf(int begin, int end) const;
  double squaredDistance(const Box& box, const std::array<double, 3>& point) const;
  void search(int node, const std::array<double, 3>& point, Place& nearest) const;
  void compare(int cell, const std::array<double, 3>& point, Place& nearest) const;
  void compareInPlane(int cell, const std::array<double, 3>& point, Place& nearest) const;

  const Mesh& mesh_;
  std::vector<int> order_; ///< cells
  std::vector<Node> nodes_;
};

} // namespace ndframe
