#include "cell_polynomial.hpp"

#include <limits>
#include <numeric>

#include "chebyshev_box.hpp"

namespace ndframe
{
namespace
{

/// (c + r u)^i = sum_p powers[i][p] u^p for i <= degree.
void powersOf(double c, double r, int degree, SubstitutionMatrix& powers)
{
  for (std::size_t i = 0; i <= std::size_t(degree); ++i)
    powers[i].fill(0.0);
  powers[0][0] = 1.0;
  for (std::size_t i = 1; i <= std::size_t(degree); ++i) {
    powers[i][0] = c * powers[i - 1][0];
    for (std::size_t p = 1; p <= i; ++p)
      powers[i][p] = c * powers[i - 1][p] + r * powers[i - 1][p - 1];
  }
}

} // namespace

void CellPolynomial::recentre(const BoxPolynomial& box, const Region::Point& centroid, double radius, double leftOut)
{
  polynomial_ = box.polynomial();
  BoxPlace& place = polynomial_.place;
  for (std::size_t axis = 0; axis < std::size_t(place.dim); ++axis)
    powersOf((centroid[axis] - place.middle[axis]) / place.halfWidth, radius / place.halfWidth, polynomial_.degree,
             powers_[axis]);
  substitute(polynomial_, {&powers_[0], &powers_[1], &powers_[2]}, rows_);
  place = {place.dim, centroid, radius};
  findDistances(box.error() + polynomial_.shorten(leftOut));
}

void CellPolynomial::findDistances(double error)
{
  const auto sizes = polynomial_.sizes();
  distances_.fill(error +
                  2.0 * std::numeric_limits<double>::epsilon() * std::accumulate(sizes.begin(), sizes.end(), 0.0));
  const PowerDistances& ofPowers = powerDistances(polynomial_.place.dim);
  for (std::size_t d = 1; d <= std::size_t(polynomial_.degree); ++d)
    for (std::size_t m = 0; m < std::min(d, distances_.size()); ++m)
      distances_[m] += sizes[d] * ofPowers[d][m];
}

} // namespace ndframe
