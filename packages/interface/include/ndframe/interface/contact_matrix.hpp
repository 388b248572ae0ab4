#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// The contact matrix C_ij = int psi_i psi_j dS of (25) on all interfaces, their nodes numbered one interface after
/// another.
///
/// C Lambda are nodal forces, sum_i (C Lambda)_i the resultant of the traction. Facet matrices are exact.
class ContactMatrix
{
public:
  explicit ContactMatrix(const std::vector<InterfaceMesh>& interfaces); ///< from facets, measures and order

  int size() const { return int(rowPtr_.size()) - 1; } ///< number of interface nodes, of all interfaces
  SparseRow row(int node) const;                       ///< C_ij of node i by j
  Vector apply(const Vector& traction) const;          ///< C Lambda: forces from tractions, per interface node
  /// C^-1 r by conjugate gradients with the diagonal: C is a mass matrix, so some 30 iterations reach round-off on any
  /// mesh.
  Vector solve(const Vector& nodalForce) const;

private:
  std::vector<int> rowPtr_, cols_;
  std::vector<double> values_, diagonal_;
};

} // namespace ndframe
