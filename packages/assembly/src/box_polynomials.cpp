#include "box_polynomials.hpp"

#include <cmath>

#include "ndframe/base/lanes.hpp"

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

/// Turns the values at Chebyshev points along each axis into coefficients of T_i T_j.
Matrix transformed(const Matrix& values, int degree)
{
  const int count = degree + 1;
  Matrix weights{}, half{}, result{};
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
      weights[std::size_t(i)][std::size_t(k)] = (i == 0 ? 1.0 : 2.0) / count * std::cos(M_PI * i * (k + 0.5) / count);
  const auto end = std::size_t(count);
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

/// Points that are worked on at a time.
constexpr int packs = 4, lanes = 4 * packs;
using Pack = double __attribute__((vector_size(4 * sizeof(double))));

/// Horner's scheme in both coordinates.
NDFRAME_EVERY_PROCESSOR void evaluate(const double* coefficients, int degree, const Pack* x, const Pack* y,
                                      Pack* result)
{
  const double* row = coefficients + std::size_t(degree + 1) * std::size_t(degree + 2) / 2;
  Pack sum[packs] = {};
  for (int j = degree; j >= 0; --j) {
    row -= degree - j + 1;
    Pack inner[packs] = {};
    for (int i = degree - j; i >= 0; --i)
      for (int p = 0; p < packs; ++p)
        inner[p] = inner[p] * x[p] + row[i];
    for (int p = 0; p < packs; ++p)
      sum[p] = sum[p] * y[p] + inner[p];
  }
  std::copy_n(sum, packs, result);
}

} // namespace

std::optional<BoxPolynomial> BoxPolynomial::fit(const ExpressionTree& tree, const Region::Point& middle,
                                                double halfWidth, double allowed)
{
  const Enclosure enclosure = enclose(tree, Region::box(2, middle, halfWidth, halfWidth));
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
  const auto coordinate = [&](std::size_t k) { return halfWidth_ * std::cos(M_PI * (double(k) + 0.5) / double(end)); };
  Matrix values{};
  for (std::size_t k = 0; k < end; ++k) {
    std::array<Region::Point, highest + 1> points{};
    for (std::size_t l = 0; l < end; ++l)
      points[l] = {middle_[0] + coordinate(k), middle_[1] + coordinate(l), 0.0};
    tree.values(points.front().data(), int(end), values[k].data());
  }
  const Matrix c = transformed(values, degree_), &T = chebyshev();
  Matrix monomials{};
  for (std::size_t i = 0; i < end; ++i)
    for (std::size_t j = 0; i + j < end; ++j)
      for (std::size_t k = i % 2; k <= i; k += 2)
        for (std::size_t l = j % 2; l <= j; l += 2)
          monomials[l][k] += c[i][j] * T[i][k] * T[j][l];
  std::size_t next = 0;
  for (std::size_t l = 0; l < end; ++l)
    for (std::size_t k = 0; k + l < end; ++k)
      coefficients_[next++] = monomials[l][k];
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

double BoxPolynomial::distance(int m, double radius) const
{
  if (m >= degree_)
    return error_;
  const double ratio = radius / halfWidth_;
  double power = 1.0;
  for (int k = 0; k <= m; ++k)
    power *= ratio;
  return error_ + derivatives_[std::size_t(m) + 1] * power;
}

bool BoxPolynomial::holds(const Region::Point& centroid, double radius) const
{
  return std::abs(centroid[0] - middle_[0]) + radius <= halfWidth_ &&
         std::abs(centroid[1] - middle_[1]) + radius <= halfWidth_;
}

void BoxPolynomial::values(const DataSampler::Vertices& vertices, const QuadratureRule& rule, double* result) const
{
  double xi[3], eta[3];
  for (std::size_t v = 0; v < 3; ++v) {
    xi[v] = (vertices[v][0] - middle_[0]) / halfWidth_;
    eta[v] = (vertices[v][1] - middle_[1]) / halfWidth_;
  }
  for (int first = 0; first < rule.size(); first += lanes) {
    const int used = std::min(lanes, rule.size() - first);
    Pack x[packs] = {}, y[packs] = {}, sum[packs];
    for (int p = 0; p < used; ++p) {
      const double* lambda = rule.point(first + p);
      x[p / 4][p % 4] = lambda[0] * xi[0] + lambda[1] * xi[1] + lambda[2] * xi[2];
      y[p / 4][p % 4] = lambda[0] * eta[0] + lambda[1] * eta[1] + lambda[2] * eta[2];
    }
    evaluate(coefficients_.data(), degree_, x, y, sum);
    for (int p = 0; p < used; ++p)
      result[first + p] = sum[p / 4][p % 4];
  }
}

const BoxPolynomial* BoxPolynomials::around(const Region::Point& centroid, double radius, double allowed)
{
  if (last_ != nullptr && last_->holds(centroid, radius) && last_->error() <= allowed)
    return last_;
  const int level = TreeBox::levelOf(radius);
  for (int up = 6; up >= 1; --up) {
    const TreeBox box(centroid, level + up, 2);
    const double aroundIt = std::ldexp(1.0, -std::min(up, 3)); // of the width, which is at least 2^up radii
    const auto [found, isNew] = boxes_.try_emplace(box.place);
    if (isNew)
      found->second = BoxPolynomial::fit(tree_, box.middle, (0.5 + aroundIt) * box.width, allowed);
    if (found->second && found->second->error() <= allowed)
      return last_ = &*found->second;
  }
  return nullptr;
}

} // namespace ndframe
