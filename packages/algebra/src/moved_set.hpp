#pragma once

#include <optional>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// From the factor L L^T of A_FF to solutions on a set G that differs in k rows: R = F without G, D = G without F. With
/// U = [E_R, A_FD], E_R unit vectors, and Y = L^-1 U
///
///   L^-1 b_F = y,   [ -N  -G ] [ s_R ]   [ 0   ]
///                   [ -G'  P ] [ s_D ] = [ b_D ] - Y^T y,   x_F = L^-T (y - Y s),  x_D = s_D,
///
/// N = Y_R^T Y_R, G = Y_R^T Y_D, P = A_DD - Y_D^T Y_D: multipliers s_R keep x_R at zero. Half a solution with L per row
/// that has not been in R or D before, k^2 products per set.
///
/// Source: block elimination; e.g. Golub and Van Loan, Matrix Computations, section 4.2 (quasidefinite systems).
class MovedSet
{
public:
  /// places: the row in the factor of every row of A, -1 where it has none. A and the factor must outlive this.
  MovedSet(const DenseMatrix& A, const DenseCholesky& factor, std::vector<int> places, double shift);

  /// False where it would take more than `most` rows in all, or A_GG may be singular: then the set is as before.
  bool moveTo(const std::vector<char>& isFree, int most);
  bool isMoved() const { return !removed_.empty() || !added_.empty(); } ///< G is not F
  /// y - Y s from y = L^-1 b_F, 0 at R, and b; s_D at the rows of x in D.
  Vector corrected(Vector y, const Vector& b, Vector& x) const;

private:
  void addColumns(const std::vector<int>& rows);
  DenseMatrix gram(const std::vector<int>& left, const std::vector<int>& right) const;
  Vector products(const std::vector<int>& columns, const Vector& y) const;

  const DenseMatrix& A_;
  const DenseCholesky& factor_;
  std::vector<int> places_;
  double shift_;
  std::vector<int> rows_;            ///< per column of Y the row of A
  std::vector<Vector> Y_;            ///< all that were needed so far
  std::vector<int> columnOf_;        ///< per row of A its column in Y, or -1
  std::vector<int> removed_, added_; ///< columns of Y
  DenseMatrix G_;
  std::optional<DenseCholesky> N_, W_; ///< of N; of P + G^T N^-1 G
};

} // namespace ndframe
