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

BoxPolynomial::BoxPolynomial(const Region::Point& middle, double halfWidth, int degree,
                             std::vector<double> coefficients, double error)
    : middle_(middle), halfWidth_(halfWidth), error_(error), degree_(degree), coefficients_(std::move(coefficients))
{
  boundDerivatives();
  error_ += 2.0 * std::numeric_limits<double>::epsilon() * derivatives_[0];
}

/// Of (xi + u)^i (eta + w)^j the coefficients of degree k in u and w add up to (i + j over k) at most.
void BoxPolynomial::boundDerivatives()
{
  std::array<double, highest + 1> ofDegree{};
  std::size_t next = 0;
  for (int j = 0; j <= degree_; ++j)
    for (int i = 0; i + j <= degree_; ++i)
      ofDegree[std::size_t(i) + std::size_t(j)] += std::abs(coefficients_[next++]);
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
  const PowerDistances& ofPowers = powerDistances();
  const double ratio = radius / halfWidth_;
  double power = ratio;
  for (std::size_t k = 1; k < derivatives_.size(); ++k, power *= ratio)
    for (std::size_t m = 0; m < std::min(k, distances_.size()); ++m)
      distances_[m] += derivatives_[k] * power * ofPowers[k][m];
  return distances_;
}

bool BoxPolynomial::holds(const Region::Point& centroid, double radius) const
{
  return std::abs(centroid[0] - middle_[0]) + radius <= halfWidth_ &&
         std::abs(centroid[1] - middle_[1]) + radius <= halfWidth_;
}

void BoxPolynomial::values(const DataSampler::Vertices& vertices, const SamplingRule& sampling, double* result) const
{
  TriangleCorners corners{};
  for (std::size_t v = 0; v < 3; ++v) {
    corners.xi[v] = (vertices[v][0] - middle_[0]) / halfWidth_;
    corners.eta[v] = (vertices[v][1] - middle_[1]) / halfWidth_;
  }
  polynomialValues(coefficients_.data(), degree_, corners, sampling, result);
}

} // namespace ndframe
