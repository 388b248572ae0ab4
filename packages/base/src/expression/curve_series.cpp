#include "curve_series.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// The k-th derivative of a polynomial divided by k!, by Horner's rule.
Interval derivative(const std::vector<double>& polynomial, std::size_t k, Interval t)
{
  double binomial = 1.0; // of j over k, from the highest j
  for (std::size_t j = k + 1; j < polynomial.size(); ++j)
    binomial *= double(j) / double(j - k);
  Interval sum;
  for (std::size_t j = polynomial.size(); j-- > k;) {
    const double coefficient = binomial * polynomial[j];
    sum = sum * t + (k == 0 ? Interval{coefficient, coefficient} : widened(coefficient, coefficient, 0x1p-46));
    binomial *= double(j - k) / double(j);
  }
  return sum;
}

} // namespace

Series affineAlong(const AffineFunction& f, const Curve& curve, Interval t, std::size_t count)
{
  Series result;
  result.count = count;
  for (std::size_t k = 0; k < count; ++k) {
    result[k] = {};
    for (std::size_t axis = 0; axis < curve.size(); ++axis)
      if (f[axis + 1] != 0.0 && k < curve[axis].size())
        result[k] = result[k] + f[axis + 1] * derivative(curve[axis], k, t);
  }
  result[0] = result[0] + Interval{f[0], f[0]};
  return result;
}

} // namespace ndframe
