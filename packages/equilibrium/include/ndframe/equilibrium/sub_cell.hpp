#pragma once

namespace ndframe
{

/// Sub-cell `sub` of a simplex: its vertices with the barycentre in place of vertex `sub`; where lambda_sub is
/// smallest.
struct SubCell
{
  int dim, /**< of the simplex, 2 or 3 */ sub; ///< 0 to dim

  /// Barycentric coordinates in the sub-cell from those in the simplex.
  void coordinates(const double* lambda, double* mu) const
  {
    for (int a = 0; a <= dim; ++a)
      mu[a] = a == sub ? (dim + 1) * lambda[a] : lambda[a] - lambda[sub];
  }
  /// And back.
  void simplexCoordinates(const double* mu, double* lambda) const
  {
    for (int a = 0; a <= dim; ++a)
      lambda[a] = mu[sub] / (dim + 1) + (a == sub ? 0.0 : mu[a]);
  }
  /// d mu_a / d x_k on the reference simplex, x_k = lambda_k for k = 1..dim (here 0..dim-1).
  double gradient(int a, int k) const
  {
    const auto ofSimplex = [k](int b) { return b == 0 ? -1.0 : (b == k + 1 ? 1.0 : 0.0); };
    return a == sub ? (dim + 1) * ofSimplex(a) : ofSimplex(a) - ofSimplex(sub);
  }
};

/// Components of a strain or stress in Voigt notation.
inline int numStrains(int dim)
{
  return dim == 2 ? 3 : 6;
}

/// Area or volume of the reference simplex.
inline double referenceMeasure(int dim)
{
  return dim == 2 ? 1.0 / 2.0 : 1.0 / 6.0;
}

/// Polynomials of a stress in one sub-cell, at most: degree 3 in the plane, 2 in space.
inline constexpr int maxStressModes = 20;

/// Place of stress component (i, j) in Voigt notation (see Elasticity).
inline int voigt(int dim, int i, int j)
{
  constexpr int inSpace[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  return dim == 2 && i != j ? 2 : inSpace[i][j];
}

/// result = factor F S F^T in Voigt notation: sigma = F S F^T / |det F| and, with the inverse map, back.
inline void transformStress(int dim, const double* F, double factor, const double* S, double* result)
{
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      double sum = 0.0;
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l)
          sum += F[i * dim + k] * F[j * dim + l] * S[voigt(dim, k, l)];
      result[voigt(dim, i, j)] = factor * sum;
    }
}

} // namespace ndframe
