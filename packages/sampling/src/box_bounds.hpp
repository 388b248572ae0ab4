#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

/// A cell of a tree of boxes that does not depend on the mesh.
struct TreeBox
{
  using Place = std::tuple<int, std::int64_t, std::int64_t, std::int64_t>; ///< level and cell
  Place place;
  Region::Point middle{};
  double width = 0.0; ///< 2^level

  /// The one around a point. space: the number of coordinates.
  TreeBox(const Region::Point& x, int level, int space);
  /// The smallest level whose width is at least a radius.
  static int levelOf(double radius);
};

/// Enclosures of one expression on a tree of boxes that does not depend on the mesh, made when they are asked for. A
/// simplex of radius r (the largest distance along an axis of a vertex from the centroid) lies in the box of width at
/// least 8 r around its centroid's cell of the tree, so that many neighbours share one enclosure.
class BoxBounds
{
public:
  BoxBounds(const ExpressionTree& tree, int space) : tree_(tree), space_(space) {}

  /// An enclosure that holds on a simplex.
  const Enclosure& around(const Region::Point& centroid, double radius);

private:
  const ExpressionTree& tree_;
  int space_;
  std::map<TreeBox::Place, Enclosure> boxes_;
  TreeBox::Place last_{}; ///< neighbours follow each other
  const Enclosure* ofLast_ = nullptr;
};

} // namespace ndframe
