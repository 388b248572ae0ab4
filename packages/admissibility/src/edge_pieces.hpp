#pragma once

#include <map>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A function on an edge as a polynomial on every piece of its samples: the one through the Gauss points.
class EdgePieces
{
public:
  /// Barycentric coordinates t of the second vertex at the ends of a piece.
  static std::array<double, 2> ends(const Samples::Piece& piece) { return {piece.corners[1], piece.corners[3]}; }

  /// The polynomial's largest value on the piece, from above: the largest Bernstein coefficient where the piece is
  /// halved as often as it takes. values: per point of the piece's rule.
  double upperBound(const QuadratureRule& rule, const double* values);
  /// 1 + Lebesgue's constant, from above: how much further from a function than its best polynomial the one through the
  /// Gauss points is.
  static double interpolationFactor(const QuadratureRule& rule) { return 1.0 + rule.size(); }
  /// The polynomial's values at the piece's first and last corner.
  std::array<double, 2> endValues(const QuadratureRule& rule, const double* values);
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
