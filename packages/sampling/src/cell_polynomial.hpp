#pragma once

#include "substitution.hpp"

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
  void findDistances(double error);

  PlacedPolynomial polynomial_;
  SmoothDistances distances_{};
  std::array<SubstitutionMatrix, 3> powers_; ///< by axis, of c + r u
  std::vector<double> rows_;
};

} // namespace ndframe
