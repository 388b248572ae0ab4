#pragma once

#include <functional>
#include <vector>

#include "star_body.hpp"

namespace ndframe
{

/// The energy matrices A_E of a solid's cells (CellForm::condensed), kept in single precision and in the axes of the
/// reference cell; sums are carried out in global axes and double precision.
class StressMatrices
{
public:
  /// use(cell, A): sees every matrix once as it is found, double precision, reference axes, symmetric.
  StressMatrices(const StarBody& body, const std::function<void(int, const DenseMatrix&)>& use);

  /// forces = the rows of tractions of A_E x for the first `count` data of a cell.
  void multiply(int cell, const double* x, int count, double* forces) const;

private:
  const StarBody* body_;
  std::vector<CellMap> maps_;
  std::vector<float> matrices_; ///< per cell: tractions x data
};

/// The columns as the reference cell sees them: F^-1 applied to every vector.
DenseMatrix pulledBack(const CellMap& map, const DenseMatrix& columns);

} // namespace ndframe
