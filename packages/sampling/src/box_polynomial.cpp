#include "box_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chebyshev_box.hpp"
#include "polynomial_values.hpp"

namespace ndframe
{
namespace
{

using Binomials = std::array<std::array<double, BoxPolynomial::highest + 1>, BoxPolynomial::highest + 1>;

const Binomials& binomialCoefficients()
{
  static const Binomials all = [] {
    Binomials made{};
    for (std::size_t d = 0; d < made.size(); ++d)
      for (std::size_t k = 0; k <= d; ++k)
        made[d][k] = k == 0 || k == d ? 1.0 : made[d - 1][k - 1] + made[d - 1][k];
    return made;
  }();
  return all;
}

} // namespace

void PlacedPolynomial::values(const DataSampler::Vertices& vertices, const SamplingRule& sampling, double* result) const
{
  BoxCorners corners{};
  for (std::size_t v = 0; v <= std::size_t(sampling.rule.dim); ++v)
    for (std::size_t k = 0; k < std::size_t(place.dim); ++k)
      corners[k][v] = (vertices[v][k] - place.middle[k]) / place.halfWidth;
  polynomialValues(coefficients.data(), degree, place.dim, corners, sampling, result);
}

std::array<double, Enclosure::longest> PlacedPolynomial::sizes() const
{
  std::array<double, Enclosure::longest> sums{};
  const double* next = coefficients.data();
  const auto rows = std::size_t(degree) + 1;
  for (std::size_t k = 0; k < (place.dim == 3 ? rows : 1); ++k)
    for (std::size_t j = 0; j + k < rows; ++j)
      for (std::size_t i = 0; i + j + k < rows; ++i)
        sums[i + j + k] += std::abs(*next++);
  return sums;
}

double PlacedPolynomial::shorten(double most)
{
  const auto ofDegree = sizes();
  int lower = degree;
  double left = 0.0;
  for (; lower > 0 && left + ofDegree[std::size_t(lower)] <= most; --lower)
    left += ofDegree[std::size_t(lower)];
  double* last = coefficients.data();
  const double* row = coefficients.data();
  for (int k = 0; k <= (place.dim == 3 ? degree : 0); ++k)
    for (int j = 0; j + k <= degree; row += degree - j - k + 1, ++j)
      last = std::copy_n(row, std::max(0, lower - j - k + 1), last);
  coefficients.resize(std::size_t(last - coefficients.data()));
  degree = lower;
  return left;
}

BoxPolynomial::BoxPolynomial(PlacedPolynomial polynomial, double error)
    : polynomial_(std::move(polynomial)), error_(error)
{
  boundDerivatives();
  error_ += 2.0 * std::numeric_limits<double>::epsilon() * derivatives_[0];
}

/// Of (xi + u)^i (eta + w)^j the coefficients of degree k in u and w add up to (i + j over k) at most; likewise with
/// three factors.
void BoxPolynomial::boundDerivatives()
{
  const auto ofDegree = polynomial_.sizes();
  derivatives_.assign(std::size_t(polynomial_.degree) + 1, 0.0);
  const Binomials& binomials = binomialCoefficients();
  for (std::size_t d = 0; d < derivatives_.size(); ++d)
    for (std::size_t k = 0; k <= d; ++k)
      derivatives_[k] += binomials[d][k] * ofDegree[d];
}

const SmoothDistances& BoxPolynomial::distances(double radius) const
{
  if (radius == radius_)
    return distances_;
  radius_ = radius;
  distances_.fill(error_);
  const PowerDistances& ofPowers = powerDistances(polynomial_.place.dim);
  const double ratio = radius / polynomial_.place.halfWidth;
  double power = ratio;
  for (std::size_t k = 1; k < derivatives_.size(); ++k, power *= ratio)
    for (std::size_t m = 0; m < std::min(k, distances_.size()); ++m)
      distances_[m] += derivatives_[k] * power * ofPowers[k][m];
  return distances_;
}

bool BoxPolynomial::holds(const Region::Point& centroid, double radius) const
{
  for (std::size_t k = 0; k < std::size_t(polynomial_.place.dim); ++k)
    if (!(std::abs(centroid[k] - polynomial_.place.middle[k]) + radius <= polynomial_.place.halfWidth))
      return false;
  return true;
}

} // namespace ndframe
