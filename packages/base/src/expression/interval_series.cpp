#include "interval_series.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-14; ///< of a range whose lower end should be zero

/// (1/k) sum_j j u_j g_(k-j): the k-th coefficient of w with w' = u' g.
Interval integrated(std::size_t k, const Series& u, const Series& g)
{
  Interval total;
  for (std::size_t j = 1; j <= k; ++j)
    if (!u[j].isZero())
      total = total + double(j) * (u[j] * g[k - j]);
  return (1.0 / double(k)) * total;
}

/// A whole power of a range.
Interval wholePower(Interval a, int p)
{
  const double low = std::pow(a.lo, p), high = std::pow(a.hi, p);
  if (p % 2 == 1)
    return widened(low, high, 0x1p-50);
  const Interval even = widened(a.contains(0.0) ? 0.0 : std::min(low, high), std::max(low, high), 0x1p-50);
  return {std::max(0.0, even.lo), even.hi};
}

Series wholePower(const Series& a, int p)
{
  if (p == 1)
    return a;
  Series result = square(wholePower(a, p / 2));
  if (p % 2 == 1)
    result = product(result, a);
  if (a[0].isBounded())
    result[0] = wholePower(a[0], p);
  return result;
}

/// a^p for a that is not negative but for rounding.
Series realPower(const Series& a, double p)
{
  Interval u = a[0];
  if (u.lo < 0.0 && -u.lo <= roundOff * u.hi)
    u.lo = 0.0;
  const double high = std::pow(std::max(0.0, u.hi), p);
  if (u.lo < 0.0 || !u.isBounded() || (u.lo == 0.0 && p < 0.0))
    return onlyRange(Interval::everything());
  if (u.lo == 0.0)
    return onlySlope(widened(0.0, high, 0x1p-50),
                     p < 1.0 ? Interval::everything() * a[1] : p * realPower(constant(u), p - 1.0)[0] * a[1]);
  Series r = emptyLike(a, a);
  r[0] = p < 0.0 ? widened(high, std::pow(u.lo, p), 0x1p-50) : widened(std::pow(u.lo, p), high, 0x1p-50);
  for (std::size_t k = 1; k < r.count; ++k) {
    Interval total;
    for (std::size_t j = 1; j <= k; ++j)
      if (!a[j].isZero())
        total = total + (p * double(j) - double(k - j)) * (a[j] * r[k - j]);
    r[k] = total / (double(k) * u);
  }
  return r;
}

} // namespace

Series emptyLike(const Series& a, const Series& b)
{
  Series result;
  result.count = std::min(a.count, b.count);
  return result;
}

Series constant(Interval value)
{
  Series result;
  result[0] = value;
  return result;
}

Series onlyRange(Interval range)
{
  Series result;
  result.terms.fill(Interval::everything());
  result[0] = range;
  return result;
}

Series onlySlope(Interval range, Interval slope)
{
  Series result = onlyRange(range);
  result[1] = slope;
  return result;
}

Series sum(const Series& a, const Series& b)
{
  Series result = emptyLike(a, b);
  for (std::size_t k = 0; k < result.count; ++k)
    result[k] = a[k] + b[k];
  return result;
}

Series negative(const Series& a)
{
  Series result = emptyLike(a, a);
  for (std::size_t k = 0; k < result.count; ++k)
    result[k] = -a[k];
  return result;
}

Series product(const Series& a, const Series& b)
{
  Series result = emptyLike(a, b);
  for (std::size_t i = 0; i < result.count; ++i)
    if (!a[i].isZero())
      for (std::size_t j = 0; i + j < result.count; ++j)
        if (!b[j].isZero())
          result[i + j] = result[i + j] + a[i] * b[j];
  return result;
}

Series square(const Series& a)
{
  Series result = product(a, a);
  if (a[0].isBounded())
    result[0] = wholePower(a[0], 2);
  return result;
}

Series quotient(const Series& a, const Series& b)
{
  if (b[0].contains(0.0))
    return onlyRange(Interval::everything());
  Series q = emptyLike(a, b);
  for (std::size_t k = 0; k < q.count; ++k) {
    Interval rest = a[k];
    for (std::size_t j = 1; j <= k; ++j)
      rest = rest - b[j] * q[k - j];
    q[k] = rest / b[0];
  }
  return q;
}

Series power(const Series& a, double p)
{
  constexpr double largest = 1024.0;
  if (p == 0.0)
    return constant({1.0, 1.0});
  if (p == std::floor(p) && std::abs(p) <= largest) {
    const Series whole = wholePower(a, int(std::abs(p)));
    return p > 0.0 ? whole : quotient(constant({1.0, 1.0}), whole);
  }
  return realPower(a, p);
}

Series exponential(const Series& a)
{
  Series e = emptyLike(a, a);
  e[0] = widened(std::exp(a[0].lo), std::exp(a[0].hi), 0x1p-50);
  e[0].lo = std::max(0.0, e[0].lo);
  for (std::size_t k = 1; k < e.count; ++k)
    e[k] = integrated(k, a, e);
  return e;
}

Series logarithm(const Series& a)
{
  if (!(a[0].lo > 0.0))
    return onlyRange(Interval::everything());
  const Series slope = quotient(constant({1.0, 1.0}), a);
  Series l = emptyLike(a, a);
  l[0] = widened(std::log(a[0].lo), std::log(a[0].hi), 0x1p-50);
  for (std::size_t k = 1; k < l.count; ++k)
    l[k] = integrated(k, a, slope);
  return l;
}

} // namespace ndframe
