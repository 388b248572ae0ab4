#pragma once

#include <vector>

#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// Continuous polynomials of order 1 or 2 on patches, by the unknowns that a projection bounds: values at the vertices
/// and one unknown x on each edge of order 2.
class FacetUnknowns
{
public:
  /// Coefficients: x is the edge's Bernstein coefficient. Values: the value at the middle, so that unknowns are nodal
  /// values.
  FacetUnknowns(const std::vector<ContactPatch>& patches, int order, TractionSign sign);

  /// From values at the nodes to unknowns and back, in place.
  void fromNodal(Vector& values) const;
  void toNodal(Vector& unknowns) const;
  /// The work of unit unknowns from that of unit nodal values: the transpose of toNodal. sum: zero before and after.
  SparseRow workFromNodal(const SparseRow& work, SparseSum& sum) const;

  /// int N_i N_j over a patch of measure 1, i and j in the order of ContactPatch::nodes, of the functions that belong
  /// to the unknowns.
  double mass(int i, int j) const;

private:
  struct Middle
  {
    int node;
    std::array<int, 2> ends;
  };

  int dim_, order_;
  bool bernstein_;              ///< false: unknowns are nodal values
  std::vector<Middle> middles_; ///< if true
  std::vector<int> middleOf_;   ///< per node the number of the middle, -1 at vertices
};

} // namespace ndframe
