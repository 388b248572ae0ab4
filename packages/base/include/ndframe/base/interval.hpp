#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace ndframe
{

/// All numbers between lo and hi; infinite ends mean that nothing is known on that side.
///
/// Every operation returns an interval that contains the exact result for all numbers of its operands: results computed
/// in round-to-nearest are widened by more than their rounding error (relative 2^-52 an operation, 2^-50 a function of
/// the C library, whose errors are below one unit in the last place). Exact zeros stay exact, so that the derivatives
/// of polynomials vanish beyond their degree.
struct Interval
{
  /// Lower end.
  double lo = 0.0, hi = 0.0; ///< upper end

  /// The interval of which nothing is known: both ends are infinite.
  static Interval everything()
  {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  bool isZero() const { return lo == 0.0 && hi == 0.0; }                    ///< only the number 0
  bool isBounded() const { return std::isfinite(lo) && std::isfinite(hi); } ///< both ends are finite
  bool contains(double value) const { return lo <= value && value <= hi; }  ///< ends included; false for NaN
  /// Largest absolute value.
  double magnitude() const { return std::max(-lo, hi); }
  double middle() const { return 0.5 * lo + 0.5 * hi; } ///< rounded; NaN for everything()
  double radius() const { return 0.5 * hi - 0.5 * lo; } ///< half the width, rounded; infinite if an end is
};

/// [lo, hi] as computed with a relative rounding error below `relative`; results below 1e-300 may have underflowed.
inline Interval widened(double lo, double hi, double relative = 0x1p-52)
{
  if (!(lo <= hi)) // a NaN: infinite ends met
    return Interval::everything();
  return {lo - std::abs(lo) * relative - 1e-300, hi + std::abs(hi) * relative + 1e-300};
}

/// The negatives, without rounding.
inline Interval operator-(Interval a)
{
  return {-a.hi, -a.lo};
}

/// All sums; zero adds no rounding.
inline Interval operator+(Interval a, Interval b)
{
  if (a.isZero() || b.isZero())
    return a.isZero() ? b : a;
  return widened(a.lo + b.lo, a.hi + b.hi);
}

/// All differences.
inline Interval operator-(Interval a, Interval b)
{
  return a + -b;
}

/// Zero times anything is zero: an unbounded factor is some number, not infinity.
inline Interval operator*(Interval a, Interval b)
{
  if (a.isZero() || b.isZero())
    return {};
  const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  if (!(std::isfinite(p) && std::isfinite(q) && std::isfinite(r) && std::isfinite(s)))
    return Interval::everything();
  return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

/// All multiples.
inline Interval operator*(double a, Interval b)
{
  return Interval{a, a} * b;
}

/// Everything when b contains zero.
inline Interval operator/(Interval a, Interval b)
{
  if (b.contains(0.0))
    return Interval::everything();
  return a * widened(1.0 / b.hi, 1.0 / b.lo);
}

/// The smallest interval that contains both.
inline Interval hull(Interval a, Interval b)
{
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

} // namespace ndframe
