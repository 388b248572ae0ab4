#pragma once

#include <array>
#include <vector>

#include "ndframe/base/expression_enclosure.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"
#include "ndframe/sampling/sampling_rules.hpp"

namespace ndframe
{

/// By the degrees that rules keep.
using SmoothDistances = std::array<double, highestKeptWhole + 1>;

/// A square or a cube.
struct BoxPlace
{
  int dim = 0; ///< 2 or 3
  Region::Point middle{};
  double halfWidth = 0.0;
};

/// The number of products of powers of degree <= n in 2 or 3 coordinates.
constexpr std::size_t numProducts(int dim, int n)
{
  const auto all = std::size_t(n + 1) * std::size_t(n + 2) / 2;
  return dim == 3 ? all * std::size_t(n + 3) / 3 : all;
}

/// sum a_ijk xi^i eta^j zeta^k with i + j + k <= degree, k by k and j by j (in a plane k = 0), the coordinates being 1
/// at the sides of `place`.
struct PlacedPolynomial
{
  BoxPlace place;
  int degree = 0;
  std::vector<double> coefficients;

  std::size_t numTerms() const { return coefficients.size(); }
  /// By i + j + k: the sum of |a_ijk|.
  std::array<double, Enclosure::longest> sizes() const;
  /// Leaves out the highest degrees whose sizes add up to `most` at most; returns their sum.
  double shorten(double most);
  /// Its values at the points of a rule on a triangle or tetrahedron; as many as its coordinates are padded to.
  void values(const DataSampler::Vertices& vertices, const SamplingRule& sampling, double* result) const;
};

/// A polynomial on a box that an expression is shown to be, to within `error`.
class BoxPolynomial
{
public:
  static constexpr int highest = Enclosure::longest - 1;

  /// To the error that of rounding in the sum of its terms is added.
  BoxPolynomial(PlacedPolynomial polynomial, double error);

  double error() const { return error_; }
  const PlacedPolynomial& polynomial() const { return polynomial_; }
  /// By m: a bound of what it misses of polynomials of degree m on simplices in the box, plus the error. radius: the
  /// largest distance along an axis of a vertex from the centroid.
  const SmoothDistances& distances(double radius) const;
  /// A simplex with this centroid and radius lies in the box.
  bool holds(const Region::Point& centroid, double radius) const;

private:
  void boundDerivatives();

  PlacedPolynomial polynomial_;
  double error_;
  /// By k: bound of the sum of the coefficients' sizes of degree k in the Taylor polynomial at any point, for
  /// coordinates of half widths.
  std::vector<double> derivatives_;
  mutable double radius_ = -1.0; ///< of the last simplex; neighbours have the same
  mutable SmoothDistances distances_{};
};

} // namespace ndframe
