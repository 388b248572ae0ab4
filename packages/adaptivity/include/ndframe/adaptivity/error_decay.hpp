#pragma once

namespace ndframe
{

/// How contributions fall where the solution is smooth: eta_K^2 ~ h^(2 p + dim) for displacements of degree p.
struct ErrorDecay
{
  int degree; ///< p
  int dim;    ///< of space, 2 or 3

  /// eta_K^2 ~ measure^(1 + 2 p / dim).
  double ofCell() const { return 1.0 + ofSum(); }
  /// The sum over the parts of a cell ~ (their measure)^(2 p / dim).
  double ofSum() const { return 2.0 * degree / dim; }
  /// lambda of a smooth solution, as corners and edges count it: sum eta_K^2 ~ r^(2 lambda) around them.
  double smoothExponent() const { return degree + 1.0; }
};

} // namespace ndframe
