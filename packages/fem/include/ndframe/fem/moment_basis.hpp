#pragma once

#include <array>
#include <vector>

namespace ndframe
{

/// Polynomials on a simplex, orthonormal for the mean value  <f, g> = 1/|S| int_S f g,  the first one 1.
///
/// Given in barycentric coordinates, so they do not depend on the simplex's shape (in recovery its vertices are in
/// ascending global number).
/// Ordered by degree: the basis of a lower degree is the beginning of this one.
/// A field f on S is represented by its moments  f_k = int_S f m_k;  f = 1/|S| sum_k f_k m_k  if it lies in the space.
/// Moments of tractions and loads are forces: entry 0 is the resultant.
class MomentBasis
{
public:
  /// No functions.
  MomentBasis() = default;
  /// All polynomials of degree <= `degree` on the simplex of dimension `dim` (1, 2, 3).
  static MomentBasis polynomials(int dim, int degree);
  /// Constants on the sub-cells of the split simplex (dim 2, 3): what the divergence of a stress of degree 1 can be.
  static MomentBasis piecewiseConstant(int dim);

  int dim() const { return dim_; }   ///< of the simplex
  int size() const { return size_; } ///< number of functions
  /// Values of all functions at a point with barycentric coordinates lambda (dim + 1 values).
  void values(const double* lambda, double* m) const;
  /// Derivatives along lambda_1..lambda_dim, lambda_0 = 1 - their sum following; dm: size x dim, row-major. Zero inside
  /// sub-cells.
  void gradients(const double* lambda, double* dm) const;
  /// Moments of the unit force at vertex a: of the function d of least degree with int_S d v = v(a) for all affine v.
  void vertexForce(int a, double* moments) const;

private:
  MomentBasis(int dim, int degree, bool piecewise);
  void polynomialValues(const double* lambda, double* m) const;

  int dim_ = 0, size_ = 0;
  bool piecewise_ = false;                 ///< each sub-cell takes the polynomials' values at its centroid
  std::vector<std::array<int, 3>> powers_; ///< of lambda_i - 1 / (dim + 1), i = 1, 2, 3
  std::vector<double> coefficients_;       ///< size x monomials, lower triangle
};

} // namespace ndframe
