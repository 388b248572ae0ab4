#pragma once

#include <optional>

#include "box_polynomial.hpp"
#include "ndframe/base/expression_enclosure.hpp"

namespace ndframe
{

/// sum c_ij T_i(xi) T_j(eta), i + j <= n, on a plane box, the coordinates being 1 at its sides: an expression f to
/// within `error`.
///
/// c is that of the interpolant of f at (m + 1)^2 Chebyshev points, m of the least degree that serves. Along one axis
/// interpolation misses f by 2^-m R_{m+1} at most, with Taylor's remainder of the box in direction of this axis, and in
/// the largest value it grows by Lebesgue's constant L = 1 + 2 / pi ln(m + 1); so
///
///   error = 2^-m (R_{m+1} along xi + L R_{m+1} along eta) + sum_{i + j > n} |c_ij|.
///
/// Sources: Rivlin, The Chebyshev Polynomials (1974), theorem 1.2, for L; docs/theory.md, section 2.
class ChebyshevBox
{
public:
  static constexpr int highest = BoxPolynomial::highest;
  static constexpr std::size_t size = highest + 1;
  using Matrix = std::array<std::array<double, size>, size>;

  /// Nothing if no degree shows an error <= `allowed`.
  static std::optional<ChebyshevBox> fit(const ExpressionTree& tree, const Region::Point& middle, double halfWidth,
                                         double allowed);
  /// The same polynomial on a box inside, less its products of highest degrees as long as the error stays <= `allowed`.
  ChebyshevBox restricted(const Region::Point& middle, double halfWidth, double allowed) const;
  /// The same polynomial, in powers.
  BoxPolynomial inPowers() const;

  double error() const { return error_; }
  int degree() const { return degree_; }

private:
  void keep(const Matrix& c, int largest, double allowed);

  Region::Point middle_{};
  double halfWidth_ = 0.0, error_ = 0.0;
  int degree_ = 0;
  std::vector<double> coefficients_; ///< c_ij, j by j
};

/// Row k, column m: the most that xi^i eta^j with i + j = k misses of polynomials of degree m on the box. Of
/// x^i = 2^(1 - i) sum_l (i over l) T_{i - 2 l} the products T_p T_q with p + q > m are left out.
using PowerDistances = std::array<SmoothDistances, BoxPolynomial::highest + 1>;
const PowerDistances& powerDistances();

} // namespace ndframe
