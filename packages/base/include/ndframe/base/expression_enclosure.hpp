#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ndframe/base/expression_tree.hpp"
#include "ndframe/base/interval.hpp"

namespace ndframe
{

/// The points that an enclosure is to hold for, as affine functions see them: everything between `points`, and the
/// directions between `directions`.
struct Region
{
  using Point = std::array<double, 3>; ///< x, y, z
  /// The region is their convex hull.
  std::vector<Point> points, directions; ///< v, along which derivatives are bounded, is in theirs

  /// A simplex, with the directions from its centroid to its points.
  static Region simplex(const std::vector<Point>& vertices);
  /// A box of the given middle and half width, with the directions of at most `step` along each axis. dim: of space.
  static Region box(int dim, const Point& middle, double halfWidth, double step);
};

/// A curve: coordinates as polynomials in t from -1 to 1, constants first.
using Curve = std::array<std::vector<double>, 3>;

/// An operation (its place in the tree) of which one sign counts as given on a region: nothing that is compared with it
/// switches there.
struct DecidedSwitch
{
  int place = -1;    ///< in ExpressionTree::nodes(); -1: none is decided
  double sign = 0.0; ///< > 0: the operation counts as >= 0, else as <= 0
};

/// What is known of an expression f on a region.
///
/// distance(m) bounds |f - q| on the region for a polynomial q of degree m: by Taylor's theorem about its middle c,
///
///   |f(x) - sum_{k < n} D^k f(c)[x - c, ...] / k!|  <=  sup |D^n f(y)[v, ...]| / n!   over points y and directions v,
///
/// enclosed by interval arithmetic on truncated Taylor series (Moore 1966). Where f has a kink only n = 1 is bounded,
/// by its Lipschitz constant; where it may jump only n = 0, by the radius of its range. Infinite: nothing is known.
struct Enclosure
{
  static constexpr int order = 10;   ///< the highest derivative, unless more are asked for
  static constexpr int longest = 26; ///< that can be asked for

  /// Of f.
  Interval range, slope, /**< of D f */ bend; ///< of f, and of D f and D^2 f / 2 along the directions
  /// By n; n = 0: the radius of the range. Infinite beyond the highest derivative.
  std::array<double, longest + 1> remainder{};
  /// An affine function that changes its sign inside, where the expression switches: the region should be cut there.
  std::optional<AffineFunction> cut;
  int curved = -1; ///< an operation, not affine, whose sign may change inside, where the expression switches

  double distance(int degree) const; ///< the least remainder with n up to degree + 1, at most `order`
};

/// Encloses an expression on a region. A comparison of affine functions that touch only at the region's boundary (to
/// 1e-13) counts as decided: the enclosure holds almost everywhere. only: all features but this one (its place in the
/// tree) keep their value in the middle; -1: all vary. order: the highest derivative, 1 or more.
Enclosure enclose(const ExpressionTree& tree, const Region& region, int only = -1, int order = Enclosure::order,
                  DecidedSwitch decided = {});

/// A bound of |f| along a curve, from its Taylor series in t on parts of it.
double largestAlong(const ExpressionTree& tree, const Curve& curve);

/// The range of an affine function on a region.
Interval rangeOf(const AffineFunction& f, const Region& region);

} // namespace ndframe
