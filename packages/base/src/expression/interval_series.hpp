#pragma once

#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

/// Truncated Taylor series with intervals as coefficients: s[k] contains D^k f(y)[v, ...] / k! for all y and v of a
/// region. The recurrences are those of automatic differentiation (Griewank and Walther 2008, chapter 13).
struct Series
{
  std::array<Interval, Enclosure::longest + 1> terms{};
  std::size_t count =
      Enclosure::longest + 1; ///< of the coefficients that are known; those of results are the operands'

  Interval& operator[](std::size_t k) { return terms[k]; }
  const Interval& operator[](std::size_t k) const { return terms[k]; }
};

/// Zero, with as many coefficients as both.
Series emptyLike(const Series& a, const Series& b);

/// The constant.
Series constant(Interval value);
/// A series of which only the range is known.
Series onlyRange(Interval range);
/// The same, with the first derivative: of a kink.
Series onlySlope(Interval range, Interval slope);

Series sum(const Series& a, const Series& b);
Series negative(const Series& a);
Series product(const Series& a, const Series& b);
Series square(const Series& a);
Series quotient(const Series& a, const Series& b);
/// a^p for a constant p.
Series power(const Series& a, double p);
Series exponential(const Series& a);
Series logarithm(const Series& a);
/// sin, cos, tan, sinh, cosh, tanh and their inverses.
Series elementary(Operation operation, const Series& a);

} // namespace ndframe
