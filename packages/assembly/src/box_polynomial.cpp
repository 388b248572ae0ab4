#include "box_polynomial.hpp"

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

BoxPolynomial::BoxPolynomial(const BoxPlace& place, int degree, std::vector<double> coefficients, double error)
    : place_(place), error_(error), degree_(degree), coefficients_(std::move(coefficients))
{
  boundDerivatives();
  error_ += 2.0 * std::numeric_limits<double>::epsilon() * derivatives_[0];
}

/// Of (xi + u)^i (eta + w)^j the coefficients of degree k in u and w add up to (i + j over k) at most; likewise with
/// three factors.
void BoxPolynomial::boundDerivatives()
{
  std::array<double, highest + 1> ofDegree{};
  std::size_t next = 0;
  for (int k = 0; k <= (place_.dim == 3 ? degree_ : 0); ++k)
    for (int j = 0; j + k <= degree_; ++j)
      for (int i = 0; i + j + k <= degree_; ++i)
        ofDegree[std::size_t(i + j + k)] += std::abs(coefficients_[next++]);
  derivatives_.assign(std::size_t(degree_) + 1, 0.0);
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
  const PowerDistances& ofPowers = powerDistances(place_.dim);
  const double ratio = radius / place_.halfWidth;
  double power = ratio;
  for (std::size_t k = 1; k < derivatives_.size(); ++k, power *= ratio)
    for (std::size_t m = 0; m < std::min(k, distances_.size()); ++m)
      distances_[m] += derivatives_[k] * power * ofPowers[k][m];
  return distances_;
}

bool BoxPolynomial::holds(const Region::Point& centroid, double radius) const
{
  for (std::size_t k = 0; k < std::size_t(place_.dim); ++k)
    if (!(std::abs(centroid[k] - place_.middle[k]) + radius <= place_.halfWidth))
      return false;
  return true;
}

void BoxPolynomial::values(const DataSampler::Vertices& vertices, const SamplingRule& sampling, double* result) const
{
  BoxCorners corners{};
  for (std::size_t v = 0; v <= std::size_t(sampling.rule.dim); ++v)
    for (std::size_t k = 0; k < std::size_t(place_.dim); ++k)
      corners[k][v] = (vertices[v][k] - place_.middle[k]) / place_.halfWidth;
  polynomialValues(coefficients_.data(), degree_, place_.dim, corners, sampling, result);
}

} // namespace ndframe
