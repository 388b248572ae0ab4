#pragma once

#include "box_polynomial.hpp"

namespace ndframe
{

/// A box's polynomial about a simplex in it, the coordinates being 1 at the simplex's radius: high powers are small
/// there, and those that do not count are left out.
///
///   p = sum b_ijk u^i v^j w^k,  (u, v, w) = (x - centroid) / radius
///
/// misses polynomials of degree m by sum_{d > m} g_dm sum_{i + j + k = d} |b_ijk| at most, with g of powerDistances().
class CellPolynomial
{
public:
  /// leftOut: the most that powers which are left out may add up to.
  void recentre(const BoxPolynomial& box, const Region::Point& centroid, double radius, double leftOut);

  /// Of the expression, by degree, as BoxPolynomial::distances.
  const SmoothDistances& distances() const { return distances_; }
  const PlacedPolynomial& polynomial() const { return polynomial_; }

private:
  void shorten(double error, double leftOut);

  PlacedPolynomial polynomial_;
  SmoothDistances distances_{};
  /// Rows of coefficients with the same j and k, and by axis the coefficients of (c + r u)^i, row by row; both padded.
  std::vector<double> rows_, powers_;
};

} // namespace ndframe
