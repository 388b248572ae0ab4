#pragma once

#include "interval_series.hpp"

namespace ndframe
{

/// The series in t of an affine function along a curve, for all t of an interval. count: of the coefficients.
Series affineAlong(const AffineFunction& f, const Curve& curve, Interval t, std::size_t count);

} // namespace ndframe
