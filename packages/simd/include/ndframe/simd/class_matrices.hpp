#pragma once

#include "ndframe/equilibrium/cell_forms.hpp"
#include "ndframe/simd/stress_cells.hpp"

namespace ndframe
{

/// The matrices A_E (CellForm::condensed) of up to CellForms::lanes cells, double precision, reference axes, over
/// tractions and loads.
struct CellMatrices
{
  const CellMap* maps;
  const double* triangle; ///< below the diagonal, column by column, per entry CellForms::lanes cells
  int size;

  /// i >= j
  const double* entry(int i, int j) const
  {
    return triangle + (std::ptrdiff_t(j) * size - std::ptrdiff_t(j) * (j - 1) / 2 + i - j) * CellForms::lanes;
  }
};

/// The energy matrices A_E (CellForm::condensed) of the classes of cells (CellClasses) that have many, over tractions
/// and loads, global axes, of the first cell of the class.
class ClassMatrices
{
public:
  /// A class has a matrix from this many cells on; that takes no more memory than what cells keep for themselves.
  static constexpr int fewest = CellForms::lanes;

  /// cells must outlive it.
  explicit ClassMatrices(const StressCells& cells);

  int size() const { return size_; }
  /// Of these, the ones of classes that have their origin in an own cell: over all ranks, every class once.
  int numOwn() const;
  /// Whether a cell's class has a matrix.
  bool has(int cell) const { return place(cell) >= 0; }
  /// The matrix of a cell's class, row by row; that of the cell is CellClasses::scale times it.
  const double* of(int cell) const { return tables_.data() + std::size_t(place(cell)) * tableSize(); }
  /// The rows and columns of tractions in single precision, divided by unit(); null where the cells are stretched.
  const float* rounded(int cell) const
  {
    return unit(cell) > 0.0 ? rounded_.data() + std::size_t(place(cell)) * tractions_ * tractions_ : nullptr;
  }
  double unit(int cell) const { return units_[std::size_t(place(cell))]; }
  int columns() const { return columns_; }

private:
  std::size_t tableSize() const { return std::size_t(columns_) * std::size_t(columns_); }
  int place(int cell) const { return place_[std::size_t(cells_->classes().of(cell))]; }
  void find(const CellForms& forms, const int* classes, int count);
  void turn(const CellMatrices& matrices, int lane, double* table) const;
  void round(std::size_t place);

  const StressCells* cells_;
  int size_ = 0, columns_;
  std::size_t tractions_;
  std::vector<int> place_; ///< per class, -1: too few cells
  Vector tables_;
  std::vector<float> rounded_;
  Vector units_; ///< per matrix its largest entry; 0 without one in single precision
};

/// Whether a cell is not much longer than wide: single precision leaves four digits of its forces.
bool isRound(const CellMap& map);

} // namespace ndframe
