#include "cell_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "chebyshev_box.hpp"
#include "ndframe/assembly/point_sums.hpp"
#include "packed_rows.hpp"

namespace ndframe
{
namespace
{

static_assert(BoxPolynomial::highest < mostPacks * packLanes, "powers fill that many packs at most");

/// (c + r u)^i = sum_p powers[i * stride + p] u^p for i <= degree; the rest of a row is zero.
void powersOf(double c, double r, int degree, std::size_t stride, double* powers)
{
  std::fill_n(powers, (std::size_t(degree) + 1) * stride, 0.0);
  powers[0] = 1.0;
  for (std::size_t i = 1; i <= std::size_t(degree); ++i) {
    const double* const last = powers + (i - 1) * stride;
    double* const next = powers + i * stride;
    next[0] = c * last[0];
    for (std::size_t p = 1; p <= i; ++p)
      next[p] = c * last[p] + r * last[p - 1];
  }
}

/// The padded rows of a polynomial's coefficients with the same j and k, i + j + k < rows.
struct Rows
{
  double* first;
  std::size_t slices, rows, stride;

  double* at(std::size_t k, std::size_t j) const { return first + (k * rows + j) * stride; }
};

enum class Along
{
  I,
  J,
  K
};

/// Replaces one coordinate. Along j and k a row takes up itself and later ones, which are as they were.
template <Along along>
inline __attribute__((always_inline)) void substitute(const Rows& b, const double* powers)
{
  for (std::size_t k = 0; k < b.slices; ++k)
    for (std::size_t j = 0; j + k < b.rows; ++j) {
      double* const row = b.at(k, j);
      const std::size_t count = b.rows - j - k, packs = (count + packLanes - 1) / packLanes;
      if constexpr (along == Along::I)
        combineRows(packs, row, 1, powers, b.stride, count, row);
      else {
        constexpr bool ofSlices = along == Along::K;
        combineRows(packs, powers + (ofSlices ? k : j) * (b.stride + 1), b.stride, row,
                    ofSlices ? b.rows * b.stride : b.stride, count, row);
      }
    }
}

/// Replaces the coordinates by c + r times new ones, whose powers are given axis by axis.
NDFRAME_EVERY_PROCESSOR void substitute(const Rows& b, const double* powers)
{
  const std::size_t ofAxis = b.rows * b.stride;
  substitute<Along::I>(b, powers);
  substitute<Along::J>(b, powers + ofAxis);
  if (b.slices > 1)
    substitute<Along::K>(b, powers + 2 * ofAxis);
}

} // namespace

void CellPolynomial::recentre(const BoxPolynomial& box, const Region::Point& centroid, double radius, double leftOut)
{
  const PlacedPolynomial& given = box.polynomial();
  const auto rows = std::size_t(given.degree) + 1, slices = given.place.dim == 3 ? rows : 1;
  const std::size_t stride = paddedCount(int(rows));
  rows_.resize(slices * rows * stride);
  powers_.resize(3 * rows * stride);
  for (std::size_t axis = 0; axis < std::size_t(given.place.dim); ++axis)
    powersOf((centroid[axis] - given.place.middle[axis]) / given.place.halfWidth, radius / given.place.halfWidth,
             given.degree, stride, powers_.data() + axis * rows * stride);
  const Rows all{rows_.data(), slices, rows, stride};
  const double* next = given.coefficients.data();
  for (std::size_t k = 0; k < slices; ++k)
    for (std::size_t j = 0; j + k < rows; next += rows - j - k, ++j)
      std::fill(std::copy_n(next, rows - j - k, all.at(k, j)), all.at(k, j) + stride, 0.0);
  substitute(all, powers_.data());
  polynomial_ = {{given.place.dim, centroid, radius}, given.degree, std::move(polynomial_.coefficients)};
  polynomial_.coefficients.clear();
  for (std::size_t k = 0; k < slices; ++k)
    for (std::size_t j = 0; j + k < rows; ++j)
      polynomial_.coefficients.insert(polynomial_.coefficients.end(), all.at(k, j), all.at(k, j) + (rows - j - k));
  shorten(box.error(), leftOut);
}

void CellPolynomial::shorten(double error, double leftOut)
{
  const auto ofDegree = polynomial_.sizes();
  int degree = polynomial_.degree;
  double left = 0.0;
  for (; degree > 0 && left + ofDegree[std::size_t(degree)] <= leftOut; --degree)
    left += ofDegree[std::size_t(degree)];
  polynomial_.truncate(degree);
  const double kept = std::accumulate(ofDegree.begin(), ofDegree.begin() + degree + 1, 0.0);
  distances_.fill(error + left + 2.0 * std::numeric_limits<double>::epsilon() * kept);
  const PowerDistances& ofPowers = powerDistances(polynomial_.place.dim);
  for (std::size_t d = 1; d <= std::size_t(degree); ++d)
    for (std::size_t m = 0; m < std::min(d, distances_.size()); ++m)
      distances_[m] += ofDegree[d] * ofPowers[d][m];
}

} // namespace ndframe
