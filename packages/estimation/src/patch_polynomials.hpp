#pragma once

#include <array>
#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Values known at some points of every cell.
struct PatchSamples
{
  int perCell = 0, components = 0;
  Vector points; ///< per cell, sample: dim coordinates
  Vector values; ///< per cell, sample: components
};

/// Coordinates of a patch: T (x - origin), T lower triangular; zero above and beyond the dimension.
using PatchFrame = std::array<std::array<double, 3>, 3>;

/// At every vertex the polynomials (one per component) nearest in least squares to the samples in the cells around it.
///
/// Rings of cells are added until there are twice as many samples as coefficients and these are well determined, in
/// coordinates in which the samples' second moments about the vertex are 1, so that stretched cells need no more rings;
/// a mesh that is too small for that gets polynomials of lower degree.
class PatchPolynomials
{
public:
  PatchPolynomials(const Mesh& mesh, int degree, const PatchSamples& samples);

  /// sum_a lambda_a p_a(x) over the vertices of a cell.
  void blend(const int* vertices, const double* lambda, const double* x, double* values) const;

private:
  class Fit;

  const Mesh& mesh_;
  int degree_, components_, terms_;
  std::vector<PatchFrame> frames_; ///< per vertex
  Vector coefficients_;            ///< per vertex, term, component
};

} // namespace ndframe
