#pragma once

#include <map>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/adaptive_samples.hpp"
#include "ndframe/recovery/moment_basis.hpp"

namespace ndframe
{

/// A function on an edge as a polynomial on every piece of its samples: the one through the Gauss points.
class EdgePieces
{
public:
  /// Barycentric coordinates t of the second vertex at the ends of a piece.
  static std::array<double, 2> ends(const Samples::Piece& piece) { return {piece.corners[1], piece.corners[3]}; }

  /// An upper bound on the piece: the largest Bernstein coefficient, and what the last Legendre coefficients show to be
  /// missing where the polynomial has not settled (a kink). values: per point of the piece's rule.
  double upperBound(const QuadratureRule& rule, const double* values);
  /// d/dt of the polynomial at the rule's points, t running over the whole edge.
  Vector derivatives(const Samples::Piece& piece, const double* values);

private:
  struct Table
  {
    MomentBasis basis;       ///< orthonormal Legendre polynomials of the degree that the points determine
    DenseMatrix toBernstein; ///< of their coefficients
  };
  const Table& table(int points);
  Vector coefficients(const QuadratureRule& rule, const double* values);

  std::map<int, Table> tables_; ///< by number of points
};

} // namespace ndframe
