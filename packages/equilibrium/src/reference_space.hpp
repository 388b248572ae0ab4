#pragma once

#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// Symmetric stresses of degree q, independent on each sub-cell of the reference simplex, and the linear maps that say
/// what they do. All integrals are exact.
class ReferenceSpace
{
public:
  ReferenceSpace(int dim, int degree);

  int strains() const { return dim_ == 2 ? 3 : 6; }
  int modes() const { return stress_.size(); } ///< functions per sub-cell and component, orthonormal there
  int coefficients() const { return (dim_ + 1) * strains() * modes(); }
  int facetModes() const { return facet_.size(); }
  int loadModes() const { return load_.size(); }
  double subCellMeasure() const;

  /// Rows that vanish when tractions are continuous inside and the divergence lies in the load space.
  DenseMatrix constraints() const;
  /// Moments of the outer facets' tractions, then of the divergence: the data of ReferenceStress.
  DenseMatrix dataMoments() const;

private:
  int column(int sub, int strain, int mode) const { return (sub * strains() + strain) * modes() + mode; }
  /// Adds the moments of the traction on the facet of sub-cell `sub` opposite to its vertex `opposite`.
  void addTraction(DenseMatrix& rows, int firstRow, int sub, int opposite) const;
  /// Coefficients of the divergence on every sub-cell in the first functions of the stress basis.
  DenseMatrix divergence() const;
  /// Mean over sub-cell `sub` of load function k times stress function l, loadModes x divergenceModes.
  DenseMatrix loadProducts(int sub) const;
  int divergenceModes() const { return divergence_.size(); }

  int dim_;
  MomentBasis stress_, divergence_, facet_, load_;
  QuadratureRule cellRule_, facetRule_;
};

} // namespace ndframe
