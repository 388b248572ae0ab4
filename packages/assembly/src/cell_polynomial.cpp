#include "cell_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "chebyshev_box.hpp"
#include "ndframe/assembly/point_sums.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = 4;
using Pack = double __attribute__((vector_size(lanes * sizeof(double))));
static_assert(BoxPolynomial::highest < 7 * lanes, "rows of seven packs at most");

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
  std::size_t length(std::size_t k, std::size_t j) const { return rows - j - k; }
};

/// sum_m factors[m] addends[m], for rows of packs; m < count.
template <std::size_t packs>
inline __attribute__((always_inline)) void combine(const double* factors, std::size_t factorStep, const double* addends,
                                                   std::size_t step, std::size_t count, double* result)
{
  Pack sum[packs] = {}, addend;
  for (std::size_t m = 0; m < count; ++m)
    for (std::size_t p = 0; p < packs; ++p) {
      load(addends + m * step + p * lanes, addend);
      sum[p] += factors[m * factorStep] * addend;
    }
  for (std::size_t p = 0; p < packs; ++p)
    store(sum[p], result + p * lanes);
}

/// The same for rows of a length of `count` at most, as those of all addends are.
inline __attribute__((always_inline)) void combine(const double* factors, std::size_t factorStep, const double* addends,
                                                   std::size_t step, std::size_t count, double* result)
{
  switch ((count + lanes - 1) / lanes) {
  case 1:
    return combine<1>(factors, factorStep, addends, step, count, result);
  case 2:
    return combine<2>(factors, factorStep, addends, step, count, result);
  case 3:
    return combine<3>(factors, factorStep, addends, step, count, result);
  case 4:
    return combine<4>(factors, factorStep, addends, step, count, result);
  case 5:
    return combine<5>(factors, factorStep, addends, step, count, result);
  case 6:
    return combine<6>(factors, factorStep, addends, step, count, result);
  default:
    return combine<7>(factors, factorStep, addends, step, count, result);
  }
}

/// Replaces the coordinates by c + r times new ones, whose powers are given axis by axis.
NDFRAME_EVERY_PROCESSOR void substitute(const Rows& b, const double* powers)
{
  const std::size_t ofAxis = b.rows * b.stride, diagonal = b.stride + 1;
  for (std::size_t k = 0; k < b.slices; ++k)
    for (std::size_t j = 0; j + k < b.rows; ++j) {
      double* const row = b.at(k, j);
      combine(row, 1, powers, b.stride, b.length(k, j), row);
    }
  for (std::size_t k = 0; k < b.slices; ++k)
    for (std::size_t j = 0; j + k < b.rows; ++j) {
      double* const row = b.at(k, j);
      combine(powers + ofAxis + j * diagonal, b.stride, row, b.stride, b.length(k, j), row);
    }
  for (std::size_t k = 0; k < b.slices && b.slices > 1; ++k)
    for (std::size_t j = 0; j + k < b.rows; ++j) {
      double* const row = b.at(k, j);
      combine(powers + 2 * ofAxis + k * diagonal, b.stride, row, b.rows * b.stride, b.length(k, j), row);
    }
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
