#pragma once

#include <functional>
#include <vector>

#include "star_body.hpp"

namespace ndframe
{

/// The energy matrices A_E of a solid's cells (CellForm::condensed) as functions of the tractions alone, kept in single
/// precision, in the axes of the reference cell and as triangles, 16 cells side by side.
class StressMatrices
{
public:
  /// Cells that are multiplied together.
  static constexpr int lanes = 16;

  /// use(cell, map, A): sees every matrix once as it is found, double precision, reference axes, symmetric, over
  /// tractions and loads.
  StressMatrices(const StarBody& body,
                 const std::function<void(int cell, const CellMap& map, const DenseMatrix& A)>& use);

  int numBatches() const { return (int(maps_.size()) + lanes - 1) / lanes; }
  /// The cells of a batch: lanes * batch .. lanes * batch + its size.
  int sizeOf(int batch) const;
  /// forces = A_E T for the cells of a batch; both cell by cell, global axes, double precision.
  void multiply(int batch, const double* T, double* forces) const;

private:
  void keep(int cell, const DenseMatrix& A);

  std::size_t tractions_;
  std::vector<CellMap> maps_;
  std::vector<float> triangles_; ///< per batch, column by column below the diagonal, lane by lane
};

/// The columns as the reference cell sees them: F^-1 applied to every vector.
DenseMatrix pulledBack(const CellMap& map, const DenseMatrix& columns);
/// sum += F^-T applied to every vector of forces there: what they are in global axes.
void addPushed(const CellMap& map, const double* forces, int count, double* sum);

} // namespace ndframe
