#pragma once

#include <vector>

#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// Continuous polynomials of order 1 or 2 on a chain of facets, by the unknowns that a projection bounds: values at the
/// vertices and one unknown x on each facet of order 2.
class FacetUnknowns
{
public:
  /// Coefficients: x is the middle Bernstein coefficient. Values: the value at the middle, so that unknowns are nodal
  /// values.
  FacetUnknowns(const std::vector<ContactFacet>& facets, int order, TractionSign sign);

  /// From values at the nodes to unknowns and back, in place.
  void fromNodal(Vector& values) const;
  void toNodal(Vector& unknowns) const;
  /// The work of unit unknowns from that of unit nodal values: the transpose of toNodal. sum: zero before and after.
  SparseRow workFromNodal(const SparseRow& work, SparseSum& sum) const;

  /// int N_i N_j over a facet of length 1, i and j in the order of ContactFacet::nodes, of the functions that belong to
  /// the unknowns.
  double mass(int i, int j) const;

private:
  const std::vector<ContactFacet>& facets_;
  int order_;
  bool bernstein_;                 ///< false: unknowns are nodal values
  std::vector<int> facetOfMiddle_; ///< per node, -1 at vertices
};

} // namespace ndframe
