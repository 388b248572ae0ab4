#pragma once

#include <array>
#include <vector>

#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// Finds the nearest facet of an interface: a tree of boxes around its (straight) facets.
///
/// n log n to build; a query descends only into boxes nearer than the best facet so far, some log n of them on any
/// grading.
class FacetTree
{
public:
  /// The mesh needs a facet and must outlive the tree.
  explicit FacetTree(const InterfaceMesh& mesh);

  struct Place
  {
    int facet = -1;
    std::array<double, 3> lambda{}; ///< barycentric coordinates of the nearest point, in [0, 1], `dim` of them
    double squaredDistance = 0.0;   ///< to that point
  };
  Place nearest(const double* point) const;

private:
  using Point = std::array<double, 3>;
  /// Around some facets; the left child follows its parent.
  struct Box
  {
    Point lower, upper;
    int facet = -1; ///< of a leaf
    int right = -1; ///< the right child
  };
  /// The tree of facets[first..last-1], which it sorts; returns the number of its root.
  int build(std::vector<int>& facets, int first, int last);
  void search(int box, const Point& x, Place& best) const;
  Place nearestOn(int facet, const Point& x) const;
  Point vertex(int facet, int local) const;
  Point centre(int facet) const;
  static double squaredDistance(const Box& box, const Point& x);

  const InterfaceMesh& mesh_;
  std::vector<Box> boxes_;
};

} // namespace ndframe
