#include <utility>

#include "interval_series.hpp"

namespace ndframe
{
namespace
{

constexpr double libraryError = 0x1p-50;
const Interval one{1.0, 1.0};

/// The coefficients from the first on of w with w' = u' g.
Series withSlope(Interval range, const Series& u, const Series& g)
{
  Series w = emptyLike(u, g);
  w[0] = range;
  for (std::size_t k = 1; k < w.count; ++k) {
    for (std::size_t j = 1; j <= k; ++j)
      w[k] = w[k] + double(j) * (u[j] * g[k - j]);
    w[k] = (1.0 / double(k)) * w[k];
  }
  return w;
}

/// cos(x) has a maximum at some 2 pi n, shifted by `shift`, for x in u; also if rounding leaves that open.
bool hasCrest(Interval u, double shift)
{
  constexpr double turn = 6.283185307179586477;
  const double slack = 1e-15 * (1.0 + u.magnitude());
  const double n = std::ceil((u.lo - shift - slack) / turn);
  return n * turn + shift <= u.hi + slack;
}

/// The range of cos(x - shift).
Interval waveRange(Interval u, double shift)
{
  constexpr double largest = 1e8; // the argument's own rounding is large beyond
  if (!u.isBounded() || u.magnitude() > largest)
    return {-1.0, 1.0};
  const double pad = 1e-15 * (1.0 + u.magnitude());
  const double a = std::cos(u.lo - shift), b = std::cos(u.hi - shift);
  const double low = hasCrest(u, shift + 3.141592653589793238) ? -1.0 : std::max(-1.0, std::min(a, b) - pad);
  const double high = hasCrest(u, shift) ? 1.0 : std::min(1.0, std::max(a, b) + pad);
  return {low, high};
}

/// sin and cos, or sinh and cosh: s' = u' c, c' = turn u' s.
std::pair<Series, Series> wave(const Series& u, Interval s0, Interval c0, double turn)
{
  Series s = emptyLike(u, u), c = s;
  s[0] = s0;
  c[0] = c0;
  for (std::size_t k = 1; k < s.count; ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      if (u[j].isZero())
        continue;
      s[k] = s[k] + double(j) * (u[j] * c[k - j]);
      c[k] = c[k] + double(j) * (u[j] * s[k - j]);
    }
    s[k] = (1.0 / double(k)) * s[k];
    c[k] = (turn / double(k)) * c[k];
  }
  return {s, c};
}

std::pair<Series, Series> circular(const Series& u)
{
  return wave(u, waveRange(u[0], 1.570796326794896619), waveRange(u[0], 0.0), -1.0);
}

std::pair<Series, Series> hyperbolic(const Series& u)
{
  const double low = std::cosh(u[0].lo), high = std::cosh(u[0].hi);
  const Interval c0 = widened(u[0].contains(0.0) ? 1.0 : std::min(low, high), std::max(low, high), libraryError);
  return wave(u, widened(std::sinh(u[0].lo), std::sinh(u[0].hi), libraryError), c0, 1.0);
}

/// w' = u' g with g = 1 - w^2, whose range 1 / cosh^2 is known better than by that formula.
Series tanhSeries(const Series& u)
{
  const auto slope = [](double x) { return 1.0 / (std::cosh(x) * std::cosh(x)); };
  const double low = slope(u[0].lo), high = slope(u[0].hi);
  Series w = emptyLike(u, u), g = w;
  w[0] = widened(std::tanh(u[0].lo), std::tanh(u[0].hi), libraryError);
  g[0] = widened(std::min(low, high), u[0].contains(0.0) ? 1.0 : std::max(low, high), libraryError);
  for (std::size_t k = 1; k < w.count; ++k) {
    for (std::size_t j = 1; j <= k; ++j)
      w[k] = w[k] + double(j) * (u[j] * g[k - j]);
    w[k] = (1.0 / double(k)) * w[k];
    for (std::size_t j = 0; j <= k; ++j)
      g[k] = g[k] - w[j] * w[k - j];
  }
  return w;
}

using Function = double (*)(double);

/// The inverse functions: monotone, with the slope (sign + factor u^2)^exponent.
struct Inverse
{
  Function function;
  double low, high; ///< where it is defined
  double constant, factor, exponent;
  bool isFalling;
};

Series inverse(const Inverse& f, const Series& u)
{
  constexpr double roundOff = 1e-13; // beyond the ends of where it is defined
  if (!(u[0].lo >= f.low - roundOff && u[0].hi <= f.high + roundOff))
    return onlyRange(Interval::everything());
  const double a = f.function(std::max(f.low, u[0].lo)), b = f.function(std::min(f.high, u[0].hi));
  const Interval range = widened(std::min(a, b), std::max(a, b), libraryError);
  Series inside = square(u);
  for (Interval& coefficient : inside.terms)
    coefficient = f.factor * coefficient;
  inside[0] = inside[0] + Interval{f.constant, f.constant};
  if (!(inside[0].lo > 0.0))
    return onlyRange(range);
  Series slope = power(inside, f.exponent);
  return withSlope(range, u, f.isFalling ? negative(slope) : slope);
}

} // namespace

Series elementary(Operation operation, const Series& a)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (operation) {
  case Operation::Sin:
    return circular(a).first;
  case Operation::Cos:
    return circular(a).second;
  case Operation::Tan: {
    const auto [s, c] = circular(a);
    return quotient(s, c);
  }
  case Operation::Sinh:
    return hyperbolic(a).first;
  case Operation::Cosh:
    return hyperbolic(a).second;
  case Operation::Tanh:
    return tanhSeries(a);
  case Operation::Asin:
    return inverse({std::asin, -1.0, 1.0, 1.0, -1.0, -0.5, false}, a);
  case Operation::Acos:
    return inverse({std::acos, -1.0, 1.0, 1.0, -1.0, -0.5, true}, a);
  case Operation::Atan:
    return inverse({std::atan, -infinity, infinity, 1.0, 1.0, -1.0, false}, a);
  case Operation::Asinh:
    return inverse({std::asinh, -infinity, infinity, 1.0, 1.0, -0.5, false}, a);
  case Operation::Acosh:
    return inverse({std::acosh, 1.0, infinity, -1.0, 1.0, -0.5, false}, a);
  default: // Atanh
    return inverse({std::atanh, -1.0, 1.0, 1.0, -1.0, -1.0, false}, a);
  }
}

} // namespace ndframe
