#pragma once

#include <array>
#include <map>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A function on a triangle as a polynomial on every piece of its samples: the one of the highest degree k <= 9 whose
/// square the piece's rule integrates, nearest to the values in the rule's mean square (so a polynomial of degree k is
/// found exactly).
class TrianglePieces
{
public:
  /// The polynomial's largest value on the piece, from above: the largest Bernstein coefficient where the piece is
  /// halved as often as it takes. values: per point of the piece's rule.
  double upperBound(const QuadratureRule& rule, const double* values);

  /// How far the function is from the polynomial at most. The projection of e, |e| <= E at the points, is
  /// sum_i w_i e_i K(x_i, x) with K the sum of products of the orthonormal polynomials; so it is at most
  /// E K(x, x)^(1/2) <= E (k + 1)(k + 2) / 2, the largest value of K on a triangle being that at a vertex, squared.
  double distance(const Samples::Piece& piece);

private:
  using Corners = std::array<std::array<double, 3>, 3>; ///< barycentric coordinates

  /// A part of a triangle, the polynomial on it.
  struct Part
  {
    Corners corners;
    Vector bernstein;
    double top() const;
  };

  struct Table
  {
    MomentBasis basis;
    std::vector<std::array<double, 3>>
        lattice;                         ///< points that determine a polynomial of the degree; vertices among them
    std::array<std::size_t, 3> vertices; ///< where
    DenseMatrix toBernstein;             ///< from the values there
  };
  const Table& table(const QuadratureRule& rule);
  Part part(const Table& table, const Vector& coefficients, const Corners& corners) const;

  std::map<int, Table> tables_; ///< by number of points of the rule
};

} // namespace ndframe
