#pragma once

#include <map>
#include <optional>

#include "box_bounds.hpp"
#include "ndframe/assembly/adaptive_samples.hpp"

namespace ndframe
{

/// A polynomial of degree n on a plane box that an expression f is shown to be, to within `error`.
///
/// It interpolates f at (n + 1)^2 Chebyshev points, less the products T_i T_j with i + j > n. This map keeps
/// polynomials of degree n, and in the largest value it grows by sqrt(2 n^2 + 2 n + 1) at most: the products that are
/// kept are orthogonal on the points, Cauchy-Schwarz. So error = (1 + sqrt(..)) R_{n+1} with Taylor's remainder of the
/// box.
class BoxPolynomial
{
public:
  static constexpr int highest = Enclosure::order - 1;

  /// Nothing if no degree shows an error <= `allowed`.
  static std::optional<BoxPolynomial> fit(const ExpressionTree& tree, const Region::Point& middle, double halfWidth,
                                          double allowed);

  double error() const { return error_; }
  /// A bound of what it misses of polynomials of degree m on simplices in the box, plus the error. radius: the largest
  /// distance along an axis of a vertex from the centroid.
  double distance(int m, double radius) const;
  /// A simplex with this centroid and radius lies in the box.
  bool holds(const Region::Point& centroid, double radius) const;
  /// Its values at the points of a rule on a triangle.
  void values(const DataSampler::Vertices& vertices, const QuadratureRule& rule, double* result) const;

private:
  static constexpr std::size_t terms = std::size_t(highest + 1) * std::size_t(highest + 2) / 2;

  void interpolate(const ExpressionTree& tree);
  void boundDerivatives();

  Region::Point middle_{};
  double halfWidth_ = 0.0, error_ = 0.0;
  int degree_ = 0;
  std::array<double, terms> coefficients_{}; ///< of xi^i eta^j, j by j, the coordinates being 1 at the box's sides
  /// By m: bound of the m-th derivative along directions of the box's half widths, divided by m!.
  std::array<double, highest + 2> derivatives_{};
};

/// Polynomials of one expression on a tree of boxes, made when they are asked for: on the largest box of 2 to 128 radii
/// on which one is shown to be good enough.
class BoxPolynomials
{
public:
  explicit BoxPolynomials(const ExpressionTree& tree) : tree_(tree) {}

  /// The one on a box that holds a simplex; null if none is shown to be right to `allowed`.
  const BoxPolynomial* around(const Region::Point& centroid, double radius, double allowed);

private:
  const ExpressionTree& tree_;
  std::map<TreeBox::Place, std::optional<BoxPolynomial>> boxes_;
  const BoxPolynomial* last_ = nullptr; ///< neighbours follow each other
};

} // namespace ndframe
