#pragma once

#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

/// An affine function on a region: its values at the points, and its changes along the directions.
struct AffineRange
{
  Interval value, slope;
  double terms = 0.0; ///< the largest sum of absolute terms, which round-off is relative to

  AffineRange(const AffineFunction& f, const Region& region);
};

/// The value of f on a region along which the coordinates that it depends on do not change by a bit; nothing on others.
std::optional<double> valueAlong(const AffineFunction& f, const Region& region);

} // namespace ndframe
