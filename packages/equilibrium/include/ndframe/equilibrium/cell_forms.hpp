#pragma once

#include <functional>

#include "ndframe/equilibrium/reference_stress.hpp"

namespace ndframe
{

/// What CellForm finds, for many cells: one product of tables and compliances for all of them, so that a cell costs
/// little more than the elimination of its bubbles. Reference axes (see ReferenceStress). compliances: one column a
/// cell (pulledBackCompliance).
class CellForms
{
public:
  explicit CellForms(const ReferenceStress& reference);

  /// CellForm::condensed of each cell. Calls use(cell, matrix) for the columns in their order; the
  /// matrix, data x data, symmetric, is overwritten by the next.
  void each(const DenseMatrix& compliances, const std::function<void(int, const DenseMatrix&)>& use) const;

  /// CellForm::coefficients: data x cells to coefficients x cells.
  DenseMatrix coefficients(const DenseMatrix& compliances, const DenseMatrix& data) const;

private:
  void condense(const double* packed, DenseMatrix& A) const;
  void addBubbles(const double* packed, const double* data, double* bubbles) const;

  const ReferenceStress& reference_;
  DenseMatrix table_;     ///< lower triangles of the tables, column by column, x entries of a compliance
  DenseMatrix ofBubbles_; ///< the same of bd, column by column, and of the lower triangle of bb
};

} // namespace ndframe
