#pragma once

#include <vector>

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// What functions may miss of polynomials, relative to their scale, in mean values. On edges gaps are polynomials point
/// by point, for which 1e-12 counts as round-off.
constexpr double agreementOn(int dim)
{
  return dim == 1 ? 1e-13 : 1e-12;
}
/// The same where functions are smooth on whole cells and faces, which are most: fewer points in tetrahedra.
constexpr double agreementOfSmoothMeans(int dim)
{
  return dim == 3 ? 4e-11 : agreementOn(dim);
}
/// And in norms, where it is charged to the oscillation.
constexpr double agreementOfNorms = 1e-11;
/// Of the polynomials whose moments with samples are right, and from which functions' distances are taken.
constexpr int degreeOfMoments(int dim)
{
  return 5 - dim;
}
/// And where functions that are smooth on whole cells and faces are concerned: what is charged is far below their
/// oscillation, and fewer points are needed.
constexpr double agreementOfSmoothNorms(int dim)
{
  return dim == 3 ? 1e-6 : 1e-8;
}

/// Or, in cells, this part of what they may miss of polynomials of degreeOfMoments().
constexpr double shareOfOscillation = 1e-4;

/// The highest degree of the polynomials that functions are compared with, on pieces of cells.
constexpr int highestKept = 9;
/// And on whole triangles and tetrahedra, where functions are known as polynomials of high degree.
constexpr int highestKeptWhole = 25;

/// A Gauss rule and the degrees of the polynomials that it integrates exactly: with polynomials of degreeOfMoments()
/// (the highest that stars integrate: a hat function times a mode), and with themselves.
struct SamplingRule
{
  QuadratureRule rule;
  int kept = 0, squared = 0;
  /// The barycentric coordinates one after the other, padded (point_sums.hpp).
  std::vector<double> padded{};
};

/// The rules that are tried one after the other. The last one, and those of edges, keep no more than they square: on an
/// edge the points determine the polynomials that are kept.
const std::vector<SamplingRule>& samplingLadder(int dim);
/// For functions that are smooth on a whole simplex: more of them in triangles and tetrahedra, none of which need
/// square all it keeps.
const std::vector<SamplingRule>& smoothLadder(int dim);

} // namespace ndframe
