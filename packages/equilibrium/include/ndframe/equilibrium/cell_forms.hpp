#pragma once

#include "ndframe/equilibrium/reference_stress.hpp"

namespace ndframe
{

/// What CellForm finds, for many cells side by side, so that a cell costs little more than the elimination of its
/// bubbles. Reference axes (see ReferenceStress).
class CellForms
{
public:
  /// Cells of condensed().
  static constexpr int lanes = 8;

  explicit CellForms(const ReferenceStress& reference);

  /// CellForm::condensed of `lanes` cells. compliances: per entry (pulledBackCompliance) and lane. Returns the lower
  /// triangle of the matrices, data x data, column by column, per entry and lane: valid until the next call of the same
  /// thread's `work`.
  const double* condensed(const double* compliances, Vector& work) const;

  /// CellForm::coefficients: data x cells to coefficients x cells; compliances: one column a cell.
  DenseMatrix coefficients(const DenseMatrix& compliances, const DenseMatrix& data) const;

private:
  void addBubbles(const double* packed, const double* data, double* bubbles) const;

  const ReferenceStress& reference_;
  Vector table_;          ///< per entry of the triangle of data, then of rows of bubbles, what compliances weigh
  DenseMatrix ofBubbles_; ///< rows of bubbles, column by column, and their lower triangle x entries of a compliance
};

} // namespace ndframe
