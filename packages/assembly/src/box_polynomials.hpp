#pragma once

#include <map>
#include <optional>

#include "box_bounds.hpp"
#include "ndframe/assembly/adaptive_samples.hpp"
#include "sampling_rules.hpp"

namespace ndframe
{

/// By the degrees that rules keep.
using SmoothDistances = std::array<double, highestKeptWhole + 1>;

/// A polynomial of degree n on a plane box that an expression f is shown to be, to within `error`.
///
/// It interpolates f at (n + 1)^2 Chebyshev points, less the products T_i T_j with i + j > n. This map keeps
/// polynomials of degree n, and in the largest value it grows by sqrt(2 n^2 + 2 n + 1) at most: the products that are
/// kept are orthogonal on the points, Cauchy-Schwarz. So error = (1 + sqrt(..)) R_{n+1} with Taylor's remainder of the
/// box.
class BoxPolynomial
{
public:
  static constexpr int highest = Enclosure::longest - 1;

  /// Nothing if no degree shows an error <= `allowed`.
  static std::optional<BoxPolynomial> fit(const ExpressionTree& tree, const Region::Point& middle, double halfWidth,
                                          double allowed);
  /// The same polynomial on a box inside, less its terms of highest degrees as long as the error stays <= `allowed`:
  /// the coordinates being at most 1 there, they are at most the sum of their coefficients.
  BoxPolynomial restricted(const Region::Point& middle, double halfWidth, double allowed) const;

  double error() const { return error_; }
  int degree() const { return degree_; }
  /// By m: a bound of what it misses of polynomials of degree m on simplices in the box, plus the error. radius: the
  /// largest distance along an axis of a vertex from the centroid.
  SmoothDistances distances(double radius) const;
  /// A simplex with this centroid and radius lies in the box.
  bool holds(const Region::Point& centroid, double radius) const;
  /// Its values at the points of a rule on a triangle; as many as the rule's coordinates are padded to.
  void values(const DataSampler::Vertices& vertices, const SamplingRule& sampling, double* result) const;

private:
  void interpolate(const ExpressionTree& tree);
  void boundDerivatives();

  Region::Point middle_{};
  double halfWidth_ = 0.0, error_ = 0.0;
  int degree_ = 0;
  std::vector<double> coefficients_; ///< of xi^i eta^j, j by j, the coordinates being 1 at the box's sides
  /// By m: bound of the m-th derivative along directions of the box's half widths, divided by m!.
  std::array<double, highest + 2> derivatives_{};
};

/// Polynomials of one expression on a tree of boxes, made when they are asked for: of high degree on large boxes, and
/// from them of degree 12 at most on the largest box of 2 to 128 radii where that is enough.
class BoxPolynomials
{
public:
  explicit BoxPolynomials(const ExpressionTree& tree) : tree_(tree) {}

  /// What follows depends on no cell before; isSame: what is allowed will be the same as before.
  void begin(bool isSame);
  /// The one on a box that holds a simplex; null if none is shown to be right to `allowed`.
  const BoxPolynomial* around(const Region::Point& centroid, double radius, double allowed);
  /// Large boxes on which the expression was evaluated.
  int fitted() const { return fitted_; }

private:
  std::optional<BoxPolynomial> make(const TreeBox& box, double halfWidth, int mostDegree, double allowed);
  const BoxPolynomial* search(const Region::Point& centroid, int level, double allowed);
  const BoxPolynomial* wholeAround(const Region::Point& middle, int level, double allowed);

  const ExpressionTree& tree_;
  std::map<TreeBox::Place, std::optional<BoxPolynomial>> whole_;
  /// By the box's width in radii, too: how far they reach beyond their cell of the tree depends on it.
  std::map<std::pair<TreeBox::Place, int>, std::optional<BoxPolynomial>> parts_;
  std::map<TreeBox::Place, const BoxPolynomial*> found_; ///< by the smallest boxes
  const BoxPolynomial* last_ = nullptr;                  ///< neighbours follow each other
  int fitted_ = 0;
};

} // namespace ndframe
