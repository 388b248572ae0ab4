#include "chebyshev_box.hpp"

#include <cmath>

#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

using Matrix = ChebyshevBox::Matrix;
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

/// b_qp = sum c_ij x_ip y_jq with lower triangular matrices x and y, for i + j <= degree. c: row by row.
NDFRAME_EVERY_PROCESSOR void substitute(const double* c, const Matrix& x, const Matrix& y, int degree, Matrix& b)
{
  const auto end = std::size_t(degree) + 1;
  Matrix half;
  for (std::size_t j = 0; j < end; c += end - j, ++j) {
    std::fill_n(half[j].begin(), end - j, 0.0);
    std::fill_n(b[j].begin(), end - j, 0.0);
    for (std::size_t i = 0; i + j < end; ++i)
      for (std::size_t p = 0; p <= i; ++p)
        half[j][p] += c[i] * x[i][p];
  }
  for (std::size_t j = 0; j < end; ++j)
    for (std::size_t q = 0; q <= j; ++q)
      for (std::size_t p = 0; p + j < end; ++p)
        b[q][p] += y[j][q] * half[j][p];
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

/// Sums over i + j = degree of |c_ij|.
double sizeOfProducts(const Matrix& c, int degree, int largest)
{
  double sum = 0.0;
  for (int j = std::max(0, degree - largest); j <= std::min(degree, largest); ++j)
    sum += std::abs(c[std::size_t(j)][std::size_t(degree - j)]);
  return sum;
}

/// The coefficients of a degree at most, row by row.
std::vector<double> listed(const Matrix& a, int degree)
{
  std::vector<double> all;
  all.reserve(std::size_t(degree + 1) * std::size_t(degree + 2) / 2);
  for (std::size_t j = 0; j <= std::size_t(degree); ++j)
    all.insert(all.end(), a[j].begin(), a[j].begin() + (degree + 1 - int(j)));
  return all;
}

/// Of the interpolant at (n + 1)^2 Chebyshev points.
Matrix interpolant(const ExpressionTree& tree, const Region::Point& middle, double halfWidth, int n)
{
  const auto end = std::size_t(n) + 1;
  const Matrix& T = atChebyshevPoints(n);
  Matrix half{}, c{};
  for (std::size_t l = 0; l < end; ++l) {
    std::array<Region::Point, size> points{};
    std::array<double, size> values{};
    for (std::size_t k = 0; k < end; ++k)
      points[k] = {middle[0] + halfWidth * T[1][k], middle[1] + halfWidth * T[1][l], 0.0};
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

/// By n: Taylor's remainder on the box along one axis.
std::array<double, Enclosure::longest + 1> remainderAlong(std::size_t axis, const ExpressionTree& tree,
                                                          const Region::Point& middle, double halfWidth)
{
  Region region = Region::box(2, middle, halfWidth, halfWidth);
  region.directions.assign(1, {});
  region.directions.front()[axis] = halfWidth;
  return enclose(tree, region, -1, Enclosure::longest).remainder;
}

} // namespace

std::optional<ChebyshevBox> ChebyshevBox::fit(const ExpressionTree& tree, const Region::Point& middle, double halfWidth,
                                              double allowed)
{
  constexpr double share = 0.5; // of what is allowed; the rest is for the products that are left out
  ChebyshevBox box;
  box.middle_ = middle;
  box.halfWidth_ = halfWidth;
  const auto alongXi = remainderAlong(0, tree, middle, halfWidth);
  if (!(std::ldexp(*std::min_element(alongXi.begin() + 1, alongXi.end()), 1 - int(size)) <= share * allowed))
    return {};
  const auto alongEta = remainderAlong(1, tree, middle, halfWidth);
  for (int m = 0; m <= highest; ++m) {
    const double lebesgue = 1.0 + 2.0 / M_PI * std::log(m + 1.0);
    box.error_ = std::ldexp(alongXi[std::size_t(m) + 1] + lebesgue * alongEta[std::size_t(m) + 1], -m);
    if (!(box.error_ <= share * allowed))
      continue;
    box.degree_ = 2 * m;
    box.keep(interpolant(tree, middle, halfWidth, m), m, allowed);
    return box.error_ <= allowed && std::isfinite(box.coefficients_[0]) ? std::optional(std::move(box)) : std::nullopt;
  }
  return {};
}

/// Keeps no products of too high a degree, and of others those without which the error would be > allowed. largest: the
/// highest degree along one axis.
void ChebyshevBox::keep(const Matrix& c, int largest, double allowed)
{
  for (; degree_ > 0; --degree_) {
    const double last = sizeOfProducts(c, degree_, largest);
    if (degree_ <= highest && !(error_ + last <= allowed))
      break;
    error_ += last;
  }
  coefficients_ = listed(c, degree_);
}

ChebyshevBox ChebyshevBox::restricted(const Region::Point& middle, double halfWidth, double allowed) const
{
  const double ratio = halfWidth / halfWidth_;
  Matrix x, y, c;
  shiftedPolynomials((middle[0] - middle_[0]) / halfWidth_, ratio, degree_, x);
  shiftedPolynomials((middle[1] - middle_[1]) / halfWidth_, ratio, degree_, y);
  substitute(coefficients_.data(), x, y, degree_, c);
  ChebyshevBox part;
  part.middle_ = middle;
  part.halfWidth_ = halfWidth;
  part.error_ = error_;
  part.degree_ = degree_;
  part.keep(c, degree_, allowed);
  return part;
}

BoxPolynomial ChebyshevBox::inPowers() const
{
  Matrix powers;
  substitute(coefficients_.data(), powersOfChebyshev(), powersOfChebyshev(), degree_, powers);
  return BoxPolynomial(middle_, halfWidth_, degree_, listed(powers, degree_), error_);
}

const PowerDistances& powerDistances()
{
  static const PowerDistances all = [] {
    Matrix products{}; // of x^i, by p
    products[0][0] = products[1][1] = 1.0;
    for (std::size_t i = 2; i < size; ++i) // x T_0 = T_1, x T_p = (T_{p+1} + T_{p-1}) / 2
      for (std::size_t p = 0; p < i; ++p) {
        products[i][p + 1] += (p == 0 ? 1.0 : 0.5) * products[i - 1][p];
        products[i][p > 0 ? p - 1 : 0] += p == 0 ? 0.0 : 0.5 * products[i - 1][p];
      }
    PowerDistances most{};
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t m = 0; m < std::min(k, most[k].size()); ++m)
        for (std::size_t i = 0; i <= k; ++i) {
          double left = 0.0;
          for (std::size_t p = 0; p <= i; ++p)
            for (std::size_t q = m + 1 > p ? m + 1 - p : 0; q <= k - i; ++q)
              left += products[i][p] * products[k - i][q];
          most[k][m] = std::max(most[k][m], left);
        }
    return most;
  }();
  return all;
}

} // namespace ndframe
