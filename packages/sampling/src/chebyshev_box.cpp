#include "chebyshev_box.hpp"

#include <cmath>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

using Matrix = ChebyshevBox::Matrix;
using Slices = std::vector<Matrix>; ///< by k, j and i
constexpr std::size_t size = ChebyshevBox::size;

/// T_i(c + r x) = sum_k result[i][k] T_k(x), by T_{i+1} = 2 (c + r x) T_i - T_{i-1}.
void shiftedPolynomials(double c, double r, int degree, Matrix& result)
{
  for (std::size_t i = 0; i <= std::size_t(degree); ++i)
    result[i].fill(0.0);
  result[0][0] = 1.0;
  if (degree == 0)
    return;
  result[1][0] = c;
  result[1][1] = r;
  for (std::size_t i = 1; i < std::size_t(degree); ++i) {
    const auto &last = result[i], &before = result[i - 1];
    auto& next = result[i + 1];
    next[0] = 2.0 * c * last[0] + r * last[1] - before[0];
    next[1] = 2.0 * c * last[1] + r * (2.0 * last[0] + (i > 1 ? last[2] : 0.0)) - before[1];
    for (std::size_t k = 2; k <= i; ++k)
      next[k] = 2.0 * c * last[k] + r * (last[k - 1] + (k < i ? last[k + 1] : 0.0)) - before[k];
    next[i + 1] = r * last[i];
  }
}

/// T_i(x) = sum_k result[i][k] x^k.
const Matrix& powersOfChebyshev()
{
  static const Matrix all = [] {
    Matrix T{};
    T[0][0] = T[1][1] = 1.0;
    for (std::size_t i = 2; i < size; ++i)
      for (std::size_t k = 0; k <= i; ++k)
        T[i][k] = (k > 0 ? 2.0 * T[i - 1][k - 1] : 0.0) - T[i - 2][k];
    return T;
  }();
  return all;
}

/// T_i at the k-th of n + 1 Chebyshev points; the points themselves are T_1.
const Matrix& atChebyshevPoints(int n)
{
  static const auto all = [] {
    std::array<Matrix, size> byNumber{};
    for (std::size_t m = 0; m < size; ++m)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k <= m; ++k)
          byNumber[m][i][k] = std::cos(M_PI * double(i) * (double(k) + 0.5) / double(m + 1));
    return byNumber;
  }();
  return all[std::size_t(n)];
}

/// Sums over i + j + k = degree of |c_ijk|, none of the three above `largest`.
double sizeOfProducts(const Slices& c, int degree, int largest)
{
  double sum = 0.0;
  for (int k = 0; k < int(c.size()) && k <= degree; ++k)
    for (int j = std::max(0, degree - k - largest); j <= std::min(degree - k, largest); ++j)
      sum += std::abs(c[std::size_t(k)][std::size_t(j)][std::size_t(degree - k - j)]);
  return sum;
}

/// The coefficients of a degree at most, slice by slice and row by row.
std::vector<double> listed(const Slices& a, int dim, int degree)
{
  std::vector<double> all;
  all.reserve(numProducts(dim, degree));
  NDFRAME_ASSERT(dim == 2 || a.size() > std::size_t(degree), "there is a slice for each degree along the third axis");
  for (std::size_t k = 0; k < a.size() && k <= std::size_t(degree); ++k)
    for (std::size_t j = 0; j + k <= std::size_t(degree); ++j)
      all.insert(all.end(), a[k][j].begin(), a[k][j].begin() + (degree + 1 - int(j + k)));
  return all;
}

/// Of the interpolant at (n + 1)^2 Chebyshev points of the plane through the middle.
Matrix interpolant(const ExpressionTree& tree, const BoxPlace& place, int n)
{
  const auto end = std::size_t(n) + 1;
  const Matrix& T = atChebyshevPoints(n);
  Matrix half{}, c{};
  for (std::size_t l = 0; l < end; ++l) {
    std::array<Region::Point, size> points{};
    std::array<double, size> values{};
    for (std::size_t k = 0; k < end; ++k)
      points[k] = {place.middle[0] + place.halfWidth * T[1][k], place.middle[1] + place.halfWidth * T[1][l],
                   place.middle[2]};
    tree.values(points.front().data(), int(end), values.data());
    for (std::size_t i = 0; i < end; ++i)
      for (std::size_t k = 0; k < end; ++k)
        half[l][i] += (i == 0 ? 1.0 : 2.0) / double(end) * T[i][k] * values[k];
  }
  for (std::size_t j = 0; j < end; ++j)
    for (std::size_t l = 0; l < end; ++l)
      for (std::size_t i = 0; i < end; ++i)
        c[j][i] += (j == 0 ? 1.0 : 2.0) / double(end) * T[j][l] * half[l][i];
  return c;
}

/// Of the one at (n + 1)^dim points. In space as many slices as the sum of the three degrees may need.
Slices interpolants(const ExpressionTree& tree, const BoxPlace& place, int n)
{
  if (place.dim == 2)
    return {interpolant(tree, place, n)};
  const auto end = std::size_t(n) + 1;
  const Matrix& T = atChebyshevPoints(n);
  Slices c(size);
  for (std::size_t l = 0; l < end; ++l) {
    BoxPlace plane = place;
    plane.middle[2] += place.halfWidth * T[1][l];
    const Matrix slice = interpolant(tree, plane, n);
    for (std::size_t k = 0; k < end; ++k)
      for (std::size_t j = 0; j < end; ++j)
        for (std::size_t i = 0; i < end; ++i)
          c[k][j][i] += (k == 0 ? 1.0 : 2.0) / double(end) * T[k][l] * slice[j][i];
  }
  return c;
}

/// By n: Taylor's remainder on the box along one axis.
std::array<double, Enclosure::longest + 1> remainderAlong(std::size_t axis, const ExpressionTree& tree,
                                                          const BoxPlace& place)
{
  Region region = Region::box(place.dim, place.middle, place.halfWidth, place.halfWidth);
  region.directions.assign(1, {});
  region.directions.front()[axis] = place.halfWidth;
  return enclose(tree, region, -1, Enclosure::longest).remainder;
}

} // namespace

std::optional<ChebyshevBox> ChebyshevBox::fit(const ExpressionTree& tree, const BoxPlace& place, double allowed)
{
  constexpr double share = 0.5; // of what is allowed; the rest is for the products that are left out
  std::array<std::array<double, Enclosure::longest + 1>, 3> along{};
  for (std::size_t k = 0; k < std::size_t(place.dim); ++k) {
    along[k] = remainderAlong(k, tree, place);
    if (!(std::ldexp(*std::min_element(along[k].begin() + 1, along[k].end()), 1 - int(size)) <= share * allowed))
      return {};
  }
  for (int m = 0; m <= highest; ++m) {
    const double lebesgue = 1.0 + 2.0 / M_PI * std::log(m + 1.0);
    const auto n = std::size_t(m) + 1;
    double error = std::ldexp(along[0][n] + lebesgue * (along[1][n] + lebesgue * along[2][n]), -m);
    if (!(error <= share * allowed))
      continue;
    const Slices c = interpolants(tree, place, m);
    int degree = place.dim * m;
    for (; degree > highest; --degree)
      error += sizeOfProducts(c, degree, m);
    ChebyshevBox box({place, degree, listed(c, place.dim, degree)}, error, allowed);
    const bool isShown = box.error_ <= allowed && std::isfinite(box.products_.coefficients.front());
    return isShown ? std::optional(std::move(box)) : std::nullopt;
  }
  return {};
}

/// Leaves out products of high degrees without which the error is <= allowed.
ChebyshevBox::ChebyshevBox(PlacedPolynomial products, double error, double allowed)
    : products_(std::move(products)), error_(error)
{
  error_ += products_.shorten(allowed - error);
}

ChebyshevBox ChebyshevBox::restricted(const BoxPlace& place, double allowed) const
{
  PlacedPolynomial part = products_;
  std::array<Matrix, 3> xyz;
  for (std::size_t k = 0; k < std::size_t(place.dim); ++k)
    shiftedPolynomials((place.middle[k] - part.place.middle[k]) / part.place.halfWidth,
                       place.halfWidth / part.place.halfWidth, part.degree, xyz[k]);
  std::vector<double> rows;
  substitute(part, {&xyz[0], &xyz[1], &xyz[2]}, rows);
  part.place = place;
  return {std::move(part), error_, allowed};
}

BoxPolynomial ChebyshevBox::inPowers() const
{
  const Matrix& T = powersOfChebyshev();
  PlacedPolynomial polynomial = products_;
  std::vector<double> rows;
  substitute(polynomial, {&T, &T, &T}, rows);
  return {std::move(polynomial), error_};
}

namespace
{

/// By i and p: the coefficient of T_p in x^i.
const Matrix& chebyshevOfPowers()
{
  static const Matrix all = [] {
    Matrix products{};
    products[0][0] = products[1][1] = 1.0;
    for (std::size_t i = 2; i < size; ++i) // x T_0 = T_1, x T_p = (T_{p+1} + T_{p-1}) / 2
      for (std::size_t p = 0; p < i; ++p) {
        products[i][p + 1] += (p == 0 ? 1.0 : 0.5) * products[i - 1][p];
        products[i][p > 0 ? p - 1 : 0] += p == 0 ? 0.0 : 0.5 * products[i - 1][p];
      }
    return products;
  }();
  return all;
}

/// By the degrees' sum: the coefficients of the products of two polynomials with coefficients that are not negative.
Matrix::value_type product(const Matrix::value_type& a, const Matrix::value_type& b)
{
  Matrix::value_type sums{};
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; p + q < size; ++q)
      sums[p + q] += a[p] * b[q];
  return sums;
}

PowerDistances makePowerDistances(int dim)
{
  const Matrix& ofPowers = chebyshevOfPowers();
  PowerDistances most{};
  for (std::size_t n = 0; n < size; ++n)
    for (std::size_t k = 0; k <= (dim == 3 ? n : 0); ++k)
      for (std::size_t j = 0; j + k <= n; ++j) {
        const auto sums = product(product(ofPowers[n - j - k], ofPowers[j]), ofPowers[k]);
        double left = 0.0;
        for (std::size_t m = n; m-- > 0;) {
          left += sums[m + 1];
          if (m < most[n].size())
            most[n][m] = std::max(most[n][m], left);
        }
      }
  return most;
}

} // namespace

const PowerDistances& powerDistances(int dim)
{
  static const PowerDistances inPlane = makePowerDistances(2), inSpace = makePowerDistances(3);
  return dim == 3 ? inSpace : inPlane;
}

} // namespace ndframe
