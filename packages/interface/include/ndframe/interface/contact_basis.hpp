#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// What the conditions of contact are asked of, per interface node: the value there, or a Bernstein coefficient of the
/// polynomials on the facets, b = B values. A polynomial of second order has the values of its vertices as coefficients
/// and, on an edge vw with the node m in its middle,
///
///   b_m = 2 x_m - (x_v + x_w) / 2,
///
/// so that b <= g at all coefficients gives x <= g at every point. Its function, the Bernstein polynomial, has a
/// positive integral on every facet; a nodal function at a vertex of a triangle has none, and carries no load.
///
/// Source: any book on geometric design, e.g. G. Farin, Curves and Surfaces for CAGD, on degree 2.
class ContactBasis
{
public:
  /// Nodes of all interfaces, one interface after another. isNodal: per node, whether its value itself is asked, as at
  /// all nodes of bodies of first order.
  ContactBasis(const std::vector<InterfaceMesh>& interfaces, const std::vector<char>& isNodal);

  int size() const { return int(rows_.size()); } ///< number of interface nodes, of all interfaces
  /// Of B: the node itself first.
  const SparseRow& row(int node) const { return rows_[std::size_t(node)]; }
  Vector coefficients(const Vector& values) const; ///< B x
  Vector values(const Vector& coefficients) const; ///< B^-1 b
  Vector nodalForces(const Vector& forces) const;  ///< B^T f: what forces that work on coefficients do at the nodes
  Vector forces(const Vector& nodalForces) const;  ///< B^-T r: of r_i = int t psi_i the integrals against the functions

private:
  std::vector<SparseRow> rows_;
};

} // namespace ndframe
