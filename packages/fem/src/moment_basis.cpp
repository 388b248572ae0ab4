#include "ndframe/fem/moment_basis.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Exponents of all monomials of degree <= `degree`, ascending in degree.
std::vector<std::array<int, 3>> monomials(int dim, int degree)
{
  std::vector<std::array<int, 3>> powers;
  for (int total = 0; total <= degree; ++total)
    for (int i = total; i >= (dim == 1 ? total : 0); --i)
      for (int j = total - i; j >= (dim == 2 ? total - i : 0); --j)
        powers.push_back({i, j, total - i - j});
  return powers;
}

double power(double base, int exponent)
{
  double result = 1.0;
  for (int i = 0; i < exponent; ++i)
    result *= base;
  return result;
}

/// Barycentric coordinates of the centroids of the sub-cells, all of the same measure.
QuadratureRule subCellCentroids(int dim)
{
  const double n = dim + 1.0;
  QuadratureRule rule;
  rule.dim = dim;
  for (int sub = 0; sub <= dim; ++sub) {
    for (int a = 0; a <= dim; ++a)
      rule.lambda.push_back(a == sub ? 1.0 / (n * n) : (1.0 + 1.0 / n) / n);
    rule.weights.push_back(1.0 / n);
  }
  return rule;
}

double product(const QuadratureRule& rule, const double* f, const double* g)
{
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.weights.size(); ++q)
    sum += rule.weights[q] * f[q] * g[q];
  return sum;
}

/// Gram-Schmidt, each function twice against those before it: orthonormal to round-off. values: size x points,
/// coefficients: size x size, both row by row.
void orthonormalise(const QuadratureRule& rule, int size, std::vector<double>& values,
                    std::vector<double>& coefficients)
{
  const int points = rule.size();
  const auto subtract = [](double* target, const double* source, int count, double factor) {
    for (int i = 0; i < count; ++i)
      target[i] -= factor * source[i];
  };
  for (int k = 0; k < size; ++k) {
    double *f = &values[std::size_t(k) * std::size_t(points)], *c = &coefficients[std::size_t(k) * std::size_t(size)];
    for (int step = 0; step < 2 * k; ++step) {
      const double* g = &values[std::size_t(step % k) * std::size_t(points)];
      const double factor = product(rule, f, g);
      subtract(f, g, points, factor);
      subtract(c, &coefficients[std::size_t(step % k) * std::size_t(size)], size, factor);
    }
    const double length = std::sqrt(product(rule, f, f));
    std::for_each(f, f + points, [length](double& x) { x /= length; });
    std::for_each(c, c + size, [length](double& x) { x /= length; });
  }
}

} // namespace

MomentBasis::MomentBasis(int dim, int degree, bool piecewise)
    : dim_(dim), piecewise_(piecewise), powers_(monomials(dim, degree))
{
  size_ = int(powers_.size());
  const std::size_t size = powers_.size();
  coefficients_.assign(size * size, 0.0);
  for (std::size_t k = 0; k < size; ++k)
    coefficients_[k * size + k] = 1.0;
  const QuadratureRule rule = piecewise ? subCellCentroids(dim) : simplexRule(dim, std::max(1, 2 * degree));
  const std::size_t points = rule.weights.size();
  std::vector<double> values(size * points), atPoint(size);
  for (std::size_t q = 0; q < points; ++q) {
    polynomialValues(rule.point(int(q)), atPoint.data());
    for (std::size_t k = 0; k < size; ++k)
      values[k * points + q] = atPoint[k];
  }
  orthonormalise(rule, size_, values, coefficients_);
}

MomentBasis MomentBasis::polynomials(int dim, int degree)
{
  NDFRAME_ASSERT(dim >= 1 && dim <= 3 && degree >= 0, "polynomials on simplices of dimension 1 to 3");
  return MomentBasis(dim, degree, false);
}

MomentBasis MomentBasis::piecewiseConstant(int dim)
{
  NDFRAME_ASSERT(dim == 2 || dim == 3, "only triangles and tetrahedra are split");
  return MomentBasis(dim, 1, true);
}

void MomentBasis::polynomialValues(const double* lambda, double* m) const
{
  std::fill(m, m + size_, 0.0);
  for (int j = 0; j < size_; ++j) {
    double monomial = 1.0;
    for (int i = 0; i < dim_; ++i)
      monomial *= power(lambda[i + 1] - 1.0 / (dim_ + 1), powers_[std::size_t(j)][std::size_t(i)]);
    for (int k = j; k < size_; ++k)
      m[k] += coefficients_[std::size_t(k) * std::size_t(size_) + std::size_t(j)] * monomial;
  }
}

void MomentBasis::values(const double* lambda, double* m) const
{
  if (!piecewise_)
    return polynomialValues(lambda, m);
  // Sub-cell i is where lambda_i is the smallest.
  const auto sub = std::min_element(lambda, lambda + dim_ + 1) - lambda;
  polynomialValues(subCellCentroids(dim_).point(int(sub)), m);
}

void MomentBasis::gradients(const double* lambda, double* dm) const
{
  std::fill(dm, dm + std::ptrdiff_t(size_) * dim_, 0.0);
  if (piecewise_)
    return;
  for (int j = 0; j < size_; ++j)
    for (int d = 0; d < dim_; ++d) {
      const int exponent = powers_[std::size_t(j)][std::size_t(d)];
      if (exponent == 0)
        continue;
      double derivative = exponent;
      for (int i = 0; i < dim_; ++i)
        derivative *= power(lambda[i + 1] - 1.0 / (dim_ + 1), powers_[std::size_t(j)][std::size_t(i)] - (i == d));
      for (int k = j; k < size_; ++k)
        dm[k * dim_ + d] += coefficients_[std::size_t(k) * std::size_t(size_) + std::size_t(j)] * derivative;
    }
}

void MomentBasis::vertexForce(int a, double* moments) const
{
  NDFRAME_ASSERT(size_ > dim_, "a force at a vertex needs the affine functions");
  double lambda[4] = {};
  lambda[a] = 1.0;
  // Moments with affine functions are their values at the vertex; on sub-cells an affine function acts through its
  // values at the centroids, which are the basis.
  polynomialValues(lambda, moments);
  std::fill(moments + dim_ + 1, moments + size_, 0.0);
}

} // namespace ndframe
