#include "line_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ndframe
{

double valueAt(const LinePolynomial& p, double t)
{
  double sum = 0.0;
  for (std::size_t k = p.size(); k-- > 0;)
    sum = sum * t + p[k];
  return sum;
}

LinePolynomial through(const std::vector<double>& values)
{
  const std::size_t n = values.size() - 1;
  LinePolynomial result(n + 1, 0.0), previous{1.0}, current{0.0, 1.0};
  for (std::size_t k = 0; k <= n; ++k) {
    double coefficient = 0.0;
    for (std::size_t j = 0; j <= n; ++j)
      coefficient += (j == 0 || j == n ? 0.5 : 1.0) * values[j] * std::cos(M_PI * double(k * j) / double(n));
    coefficient *= (k == 0 || k == n ? 1.0 : 2.0) / double(n);
    for (std::size_t i = 0; i < previous.size(); ++i)
      result[i] += coefficient * previous[i];
    LinePolynomial next(current.size() + 1, 0.0); // 2 t T_k+1 - T_k
    for (std::size_t i = 0; i < current.size(); ++i)
      next[i + 1] = 2.0 * current[i];
    for (std::size_t i = 0; i < previous.size(); ++i)
      next[i] -= previous[i];
    previous = std::exchange(current, next);
  }
  return result;
}

double leastCoefficient(const LinePolynomial& p)
{
  const std::size_t n = p.size() - 1;
  LinePolynomial shifted(p); // in s = (t + 1) / 2
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = n; k-- > i;)
      shifted[k] -= shifted[k + 1];
  double power = 1.0, least = std::numeric_limits<double>::infinity();
  for (auto& coefficient : shifted)
    coefficient *= std::exchange(power, 2.0 * power);
  for (std::size_t j = 0; j <= n; ++j) {
    double sum = 0.0, ratio = 1.0; // of j over k to n over k
    for (std::size_t k = 0; k <= j; ++k) {
      sum += ratio * shifted[k];
      ratio *= double(j - k) / double(std::max<std::size_t>(n - k, 1));
    }
    least = std::min(least, sum);
  }
  return least;
}

LinePolynomial differenceOf(LinePolynomial a, const LinePolynomial& b)
{
  a.resize(std::max(a.size(), b.size()), 0.0);
  for (std::size_t k = 0; k < b.size(); ++k)
    a[k] -= b[k];
  return a;
}

} // namespace ndframe
