#include "box_polynomials.hpp"

#include <cmath>

#include "ndframe/base/lanes.hpp"
#include "polynomial_values.hpp"

namespace ndframe
{
namespace
{

constexpr int largestDegree = BoxPolynomial::highest;
using Matrix = std::array<std::array<double, largestDegree + 1>, largestDegree + 1>;

/// T_i(x) = sum_k matrix[i][k] x^k.
const Matrix& chebyshev()
{
  static const Matrix all = [] {
    Matrix T{};
    T[0][0] = T[1][1] = 1.0;
    for (std::size_t i = 2; i < T.size(); ++i)
      for (std::size_t k = 0; k <= i; ++k)
        T[i][k] = (k > 0 ? 2.0 * T[i - 1][k - 1] : 0.0) - T[i - 2][k];
    return T;
  }();
  return all;
}

/// T_i at the k-th of n + 1 Chebyshev points; the points themselves are T_1.
const Matrix& atChebyshevPoints(int degree)
{
  static const auto all = [] {
    std::array<Matrix, largestDegree + 1> byDegree{};
    for (std::size_t n = 0; n < byDegree.size(); ++n)
      for (std::size_t i = 0; i < byDegree.size(); ++i)
        for (std::size_t k = 0; k <= n; ++k)
          byDegree[n][i][k] = std::cos(M_PI * double(i) * (double(k) + 0.5) / double(n + 1));
    return byDegree;
  }();
  return all[std::size_t(degree)];
}

/// Turns the values at Chebyshev points along each axis into coefficients of T_i T_j.
Matrix transformed(const Matrix& values, int degree)
{
  const auto end = std::size_t(degree) + 1;
  Matrix weights = atChebyshevPoints(degree), half{}, result{};
  for (std::size_t i = 0; i < end; ++i)
    for (std::size_t k = 0; k < end; ++k)
      weights[i][k] *= (i == 0 ? 1.0 : 2.0) / double(end);
  for (std::size_t i = 0; i < end; ++i)
    for (std::size_t k = 0; k < end; ++k)
      for (std::size_t l = 0; l < end; ++l)
        half[i][l] += weights[i][k] * values[k][l];
  for (std::size_t i = 0; i < end; ++i)
    for (std::size_t j = 0; i + j < end; ++j)
      for (std::size_t l = 0; l < end; ++l)
        result[i][j] += weights[j][l] * half[i][l];
  return result;
}

double growth(int degree)
{
  return std::sqrt(2.0 * degree * degree + 2.0 * degree + 1.0);
}

/// Coefficients by power along the first index, as functions of x = c + r x'.
NDFRAME_EVERY_PROCESSOR void shift(Matrix& a, int degree, double c, double r)
{
  const auto end = std::size_t(degree);
  for (std::size_t k = 0; k < end; ++k)
    for (std::size_t i = end; i-- > k;)
      for (std::size_t j = 0; i + j < end; ++j)
        a[i][j] += c * a[i + 1][j];
  double power = 1.0;
  for (std::size_t i = 0; i <= end; ++i, power *= r)
    for (std::size_t j = 0; i + j <= end; ++j)
      a[i][j] *= power;
}

void transpose(Matrix& a)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      std::swap(a[i][j], a[j][i]);
}

/// The terms of a degree at most, as they are stored.
std::vector<double> listed(const Matrix& a, int degree)
{
  std::vector<double> all;
  for (std::size_t j = 0; j <= std::size_t(degree); ++j)
    all.insert(all.end(), a[j].begin(), a[j].begin() + (degree + 1 - int(j)));
  return all;
}

} // namespace

std::optional<BoxPolynomial> BoxPolynomial::fit(const ExpressionTree& tree, const Region::Point& middle,
                                                double halfWidth, double allowed)
{
  const Enclosure enclosure = enclose(tree, Region::box(2, middle, halfWidth, halfWidth), -1, Enclosure::longest);
  BoxPolynomial polynomial;
  polynomial.middle_ = middle;
  polynomial.halfWidth_ = halfWidth;
  for (int n = 0; n <= highest; ++n) {
    polynomial.degree_ = n;
    polynomial.error_ = (1.0 + growth(n)) * enclosure.remainder[std::size_t(n) + 1];
    if (!(polynomial.error_ <= allowed))
      continue;
    polynomial.interpolate(tree);
    polynomial.boundDerivatives();
    return std::isfinite(polynomial.derivatives_[0]) ? std::optional(polynomial) : std::nullopt;
  }
  return {};
}

void BoxPolynomial::interpolate(const ExpressionTree& tree)
{
  const auto end = std::size_t(degree_) + 1;
  const auto& onAxis = atChebyshevPoints(degree_)[1];
  Matrix values{};
  for (std::size_t k = 0; k < end; ++k) {
    std::array<Region::Point, highest + 1> points{};
    for (std::size_t l = 0; l < end; ++l)
      points[l] = {middle_[0] + halfWidth_ * onAxis[k], middle_[1] + halfWidth_ * onAxis[l], 0.0};
    tree.values(points.front().data(), int(end), values[k].data());
  }
  const Matrix c = transformed(values, degree_), &T = chebyshev();
  Matrix monomials{};
  for (std::size_t i = 0; i < end; ++i)
    for (std::size_t j = 0; i + j < end; ++j)
      for (std::size_t k = i % 2; k <= i; k += 2)
        for (std::size_t l = j % 2; l <= j; l += 2)
          monomials[l][k] += c[i][j] * T[i][k] * T[j][l];
  coefficients_ = listed(monomials, degree_);
}

BoxPolynomial BoxPolynomial::restricted(const Region::Point& middle, double halfWidth, double allowed) const
{
  Matrix a{};
  std::size_t next = 0;
  for (std::size_t j = 0; j <= std::size_t(degree_); ++j)
    for (std::size_t i = 0; i + j <= std::size_t(degree_); ++i)
      a[j][i] = coefficients_[next++];
  const double ratio = halfWidth / halfWidth_;
  shift(a, degree_, (middle[1] - middle_[1]) / halfWidth_, ratio);
  transpose(a);
  shift(a, degree_, (middle[0] - middle_[0]) / halfWidth_, ratio);
  transpose(a);
  BoxPolynomial part;
  part.middle_ = middle;
  part.halfWidth_ = halfWidth;
  part.error_ = error_;
  part.degree_ = degree_;
  for (; part.degree_ > 0; --part.degree_) {
    double last = 0.0;
    for (std::size_t j = 0, d = std::size_t(part.degree_); j <= d; ++j)
      last += std::abs(a[j][d - j]);
    if (!(part.error_ + last <= allowed))
      break;
    part.error_ += last;
  }
  part.coefficients_ = listed(a, part.degree_);
  part.boundDerivatives();
  return part;
}

/// In direction v of at most half a width along each axis xi^i eta^j has a coefficient of t^m that is at most
/// (i + j over m) in (xi + t v_1)^i (eta + t v_2)^j.
void BoxPolynomial::boundDerivatives()
{
  std::array<double, highest + 1> ofDegree{};
  std::size_t next = 0;
  for (int j = 0; j <= degree_; ++j)
    for (int i = 0; i + j <= degree_; ++i)
      ofDegree[std::size_t(i) + std::size_t(j)] += std::abs(coefficients_[next++]);
  for (int m = 0; m <= degree_; ++m) {
    double binomial = 1.0;
    for (int d = m; d <= degree_; ++d) {
      derivatives_[std::size_t(m)] += binomial * ofDegree[std::size_t(d)];
      binomial *= double(d + 1) / (d + 1 - m);
    }
  }
}

SmoothDistances BoxPolynomial::distances(double radius) const
{
  SmoothDistances all{};
  const double ratio = radius / halfWidth_;
  double power = ratio;
  for (std::size_t m = 0; m < all.size(); ++m, power *= ratio)
    all[m] = error_ + derivatives_[m + 1] * power;
  return all;
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

void BoxPolynomials::begin(bool isSame)
{
  last_ = nullptr;
  if (isSame)
    return;
  whole_.clear();
  parts_.clear();
  found_.clear();
}

/// The one of high degree on the largest box around a cell of the tree, up to 32 times as wide.
const BoxPolynomial* BoxPolynomials::wholeAround(const Region::Point& middle, int level, double allowed)
{
  for (int up = 5; up >= 0; --up) {
    const TreeBox box(middle, level + up, 2);
    const auto [found, isNew] = whole_.try_emplace(box.place);
    if (isNew) {
      found->second = BoxPolynomial::fit(tree_, box.middle, box.width, allowed); // what is inside reaches beyond it
      fitted_ += found->second ? 1 : 0;
    }
    if (found->second && found->second->error() <= allowed)
      return &*found->second;
  }
  return nullptr;
}

std::optional<BoxPolynomial> BoxPolynomials::make(const TreeBox& box, double halfWidth, int mostDegree, double allowed)
{
  constexpr double share = 0.5; // of what is allowed; the rest is for the terms that are left out
  const BoxPolynomial* whole = wholeAround(box.middle, std::get<0>(box.place), share * allowed);
  if (whole == nullptr)
    return {};
  auto part = whole->restricted(box.middle, halfWidth, allowed);
  return part.degree() <= mostDegree ? std::optional(std::move(part)) : std::nullopt;
}

/// The largest box of the tree around a cell on which a part is known, from 2^6 radii downwards.
const BoxPolynomial* BoxPolynomials::search(const Region::Point& centroid, int level, double allowed)
{
  constexpr int cheap = 12; // degree: rather one more than parts of few triangles
  for (int up = 6; up >= 1; --up) {
    const TreeBox box(centroid, level + up, 2);
    const double aroundIt = std::ldexp(1.0, -up); // of the width, which is at least 2^up radii
    const auto [found, isNew] = parts_.try_emplace({box.place, up});
    if (isNew)
      found->second = make(box, (0.5 + aroundIt) * box.width, up == 1 ? BoxPolynomial::highest : cheap, allowed);
    if (found->second && found->second->error() <= allowed)
      return &*found->second;
  }
  return nullptr;
}

/// All cells of the smallest box have the same answer.
const BoxPolynomial* BoxPolynomials::around(const Region::Point& centroid, double radius, double allowed)
{
  if (last_ != nullptr && last_->holds(centroid, radius) && last_->error() <= allowed)
    return last_;
  const int level = TreeBox::levelOf(radius);
  const auto [found, isNew] = found_.try_emplace(TreeBox(centroid, level + 1, 2).place);
  if (isNew)
    found->second = search(centroid, level, allowed);
  if (found->second != nullptr)
    last_ = found->second;
  return found->second;
}

} // namespace ndframe
