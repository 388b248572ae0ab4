#include "ndframe/fem/quadrature.hpp"

#include <cmath>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Legendre polynomial of degree n and its derivative at x, by the three-term recurrence.
std::pair<double, double> legendre(int n, double x)
{
  double previous = 1.0, value = x;
  for (int k = 2; k <= n; ++k)
    previous = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * previous) / k);
  return {value, n * (x * value - previous) / (x * x - 1.0)};
}

struct GaussRule
{
  std::vector<double> points, weights; ///< on (0, 1), weights add up to 1
};

/// Gauss-Legendre rule with n >= 2 points, roots by Newton's method.
GaussRule gauss(int n)
{
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; ++step) {
      const auto [value, slope] = legendre(n, x);
      x -= value / slope;
      if (std::abs(value / slope) < 1e-15)
        break;
    }
    const double slope = legendre(n, x).second;
    rule.points.push_back(0.5 * (1.0 - x));
    rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

/// The symmetric rule with dim + 1 points, exact for degree 2.
QuadratureRule symmetricRule(int dim)
{
  const double a = (1.0 - 1.0 / std::sqrt(dim + 2.0)) / (dim + 1.0);
  QuadratureRule rule{dim, {}, std::vector<double>(std::size_t(dim + 1), 1.0 / (dim + 1))};
  for (int q = 0; q <= dim; ++q)
    for (int k = 0; k <= dim; ++k)
      rule.lambda.push_back(k == q ? 1.0 - dim * a : a);
  return rule;
}

} // namespace

QuadratureRule simplexRule(int dim, int degree)
{
  NDFRAME_ASSERT(dim >= 1 && dim <= 3 && degree >= 0, "no quadrature rule of this kind");
  if (degree <= 2)
    return symmetricRule(dim);
  // Collapse the cube: x_1 = t_1, x_2 = (1 - t_1) t_2, ...; the Jacobian raises the degree in t_k by dim - k.
  const GaussRule line = gauss((degree + dim - 1) / 2 + 1);
  const int n = int(line.points.size());
  QuadratureRule rule{dim, {}, {}};
  int total = 1;
  for (int k = 0; k < dim; ++k)
    total *= n;
  for (int q = 0; q < total; ++q) {
    double rest = 1.0, weight = dim == 3 ? 6.0 : double(dim);
    double lambda[4];
    int index = q;
    for (int k = 0; k < dim; ++k, index /= n) {
      const double t = line.points[std::size_t(index % n)];
      weight *= line.weights[std::size_t(index % n)] * rest;
      lambda[k + 1] = rest * t;
      rest *= 1.0 - t;
    }
    lambda[0] = rest;
    rule.lambda.insert(rule.lambda.end(), lambda, lambda + dim + 1);
    rule.weights.push_back(weight);
  }
  return rule;
}

} // namespace ndframe
