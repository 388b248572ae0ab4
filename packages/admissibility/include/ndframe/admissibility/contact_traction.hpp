#pragma once

#include "ndframe/admissibility/contact_patch.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// Normal tractions t_N <= 0 on the patches of all interfaces, as polynomials of degree q that may jump from patch to
/// patch, divided into the shares of the vertices' stars. Acts on side 0 along n_c, on side 1 against it.
struct ContactTraction
{
  int degree = 0; ///< q, at least the order of the displacements
  Vector shares;  ///< per patch, per vertex, per mode (of facetBasis): int t_a L_k, a force
  /// Where n_c turns: what the stresses carry of t n_c, which is of one degree more than t (contactOscillation has the
  /// rest). Laid out like `shares` with `dim` components a mode; zero on patches that do not turn, empty without any
  /// that does.
  Vector vectors{};
  int dim = 2; ///< of space

  std::size_t numModes() const { return std::size_t(numFacetModes(dim, degree)); } ///< polynomials on a patch
  /// Where the share of a vertex begins among `shares`.
  std::size_t first(std::size_t patch, std::size_t vertex) const
  {
    return (patch * std::size_t(dim) + vertex) * numModes();
  }
  /// Moments of the whole traction on a patch, per mode.
  Vector moments(int patch) const;
};

/// What side 0 of every patch feels, along n_c, and what side 1 feels, against it: the same traction where it is
/// admissible.
using SideTractions = std::array<ContactTraction, 2>;

/// Bernstein coefficients (rows; on edges ascending from the first vertex) of the polynomials with unit moments
/// (columns) on a facet of unit measure: sum_k T_k L_k / |f| has the coefficients bernsteinOfMoments T / |f|.
DenseMatrix bernsteinOfMoments(int dim, int degree);

/// The largest of the values on all patches that `map` makes of the moments of t_N on a facet of unit measure.
double largestOfMoments(const DenseMatrix& map, const ContactTraction& traction,
                        const std::vector<ContactPatch>& patches);

/// Largest Bernstein coefficient of t_N over all patches: not above 0 means t_N <= 0 everywhere.
double largestBernstein(const ContactTraction& traction, const std::vector<ContactPatch>& patches);

/// A traction from nodal values: continuous, of the displacements' order, shares as StaticData explains them.
ContactTraction tractionFromNodes(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree);

/// The shares of one body's patches (patchesOfBody) in global axes, as FieldInput::contact wants them: in the body's
/// own order of vertices, with the sign and the traction of its side.
Vector contactShares(const std::vector<ContactPatch>& patches, const SideTractions& tractions, int body);

} // namespace ndframe
