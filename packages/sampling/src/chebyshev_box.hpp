#pragma once

#include <optional>

#include "ndframe/base/expression_enclosure.hpp"
#include "substitution.hpp"

namespace ndframe
{

/// sum c_ijk T_i(xi) T_j(eta) T_k(zeta), i + j + k <= n, on a box, the coordinates being 1 at its sides (a plane one
/// has k = 0 only): an expression f to within `error`.
///
/// c is that of the interpolant of f at (m + 1)^dim Chebyshev points, m of the least degree that serves. Along one axis
/// interpolation misses f by 2^-m R_{m+1} at most, with Taylor's remainder of the box in direction of this axis, and in
/// the largest value it grows by Lebesgue's constant L = 1 + 2 / pi ln(m + 1); so
///
///   error = 2^-m (R_{m+1} along xi + L R_{m+1} along eta + L^2 R_{m+1} along zeta) + sum_{i + j + k > n} |c_ijk|.
///
/// Sources: Rivlin, The Chebyshev Polynomials (1974), theorem 1.2, for L; docs/theory.md, section 2.
class ChebyshevBox
{
public:
  static constexpr int highest = BoxPolynomial::highest;
  static constexpr std::size_t size = highest + 1;
  using Matrix = SubstitutionMatrix;

  /// Nothing if no degree shows an error <= `allowed`.
  static std::optional<ChebyshevBox> fit(const ExpressionTree& tree, const BoxPlace& place, double allowed);
  /// The same polynomial on a box inside, less its products of highest degrees as long as the error stays <= `allowed`.
  ChebyshevBox restricted(const BoxPlace& place, double allowed) const;
  /// The same polynomial, in powers.
  BoxPolynomial inPowers() const;

  double error() const { return error_; }
  int degree() const { return products_.degree; }

private:
  ChebyshevBox(PlacedPolynomial products, double error, double allowed);

  PlacedPolynomial products_; ///< of Chebyshev polynomials: c_ijk
  double error_;
};

/// Row n, column m: the most that a product of powers of degree n misses of polynomials of degree m on the box. Of
/// x^i = 2^(1 - i) sum_l (i over l) T_{i - 2 l} the products T_p T_q T_r with p + q + r > m are left out.
using PowerDistances = std::array<SmoothDistances, BoxPolynomial::highest + 1>;
/// dim: of the box, 2 or 3.
const PowerDistances& powerDistances(int dim);

} // namespace ndframe
