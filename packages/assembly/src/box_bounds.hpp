#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

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
  using Place = std::tuple<int, std::int64_t, std::int64_t, std::int64_t>; ///< level and cell
  std::map<Place, Enclosure> boxes_;
  Place last_{}; ///< neighbours follow each other
  const Enclosure* ofLast_ = nullptr;
};

} // namespace ndframe
