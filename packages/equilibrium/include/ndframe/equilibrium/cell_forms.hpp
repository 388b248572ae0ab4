#pragma once

#include <functional>

#include "ndframe/equilibrium/reference_stress.hpp"

namespace ndframe
{

/// The matrices of CellForm::condensed for many cells: one product of tables and compliances for all of them, so that
/// a cell costs little more than the elimination of its bubbles. Reference axes (see ReferenceStress).
class CellForms
{
public:
  explicit CellForms(const ReferenceStress& reference);

  /// compliances: one column a cell (pulledBackCompliance). Calls use(cell, matrix) for the columns in their order; the
  /// matrix, data x data, symmetric, is overwritten by the next.
  void each(const DenseMatrix& compliances, const std::function<void(int, const DenseMatrix&)>& use) const;

private:
  void condense(const double* packed, DenseMatrix& A) const;

  const ReferenceStress& reference_;
  DenseMatrix table_; ///< lower triangles of the tables, column by column, x entries of a compliance
};

} // namespace ndframe
