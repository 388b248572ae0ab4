#pragma once

#include "stress_faces.hpp"
#include "stress_matrices.hpp"

namespace ndframe
{

/// What cells' matrices mean for the tractions of their faces: X_f^T A_fg X_g, X the columns that a face's unknowns
/// stand for. Some cells side by side, up to CellForms::lanes.
class CellBlocks
{
public:
  static constexpr int mostCarriers = 6; ///< of a face

  /// facetData: numbers that a facet's tractions have.
  explicit CellBlocks(int facetData);

  void clear();
  /// The face at a cell's facet, which the cell is on this side of.
  void put(int lane, int facet, const StressFace& face, std::size_t side);
  /// To be called when all have been put.
  void compute(const CellMatrices& matrices);

  /// Appends own^T A own of a face with `size` own unknowns, column by column.
  void addOwn(int lane, int facet, int size, Vector& values) const;
  /// carriers^T A carriers of all faces, mostCarriers for each; where a face has fewer, nothing
  /// that means anything.
  DenseMatrix ofCarriers(int lane) const;

private:
  static constexpr std::ptrdiff_t lanes = CellForms::lanes, mostRows = 18, mostOwn = 12,
                                  mostColumns = mostOwn + mostCarriers;

  /// A column of each lane, own ones first; rows first .. last are not zero in some lane.
  struct Column
  {
    double* values = nullptr; ///< mostRows x lanes
    int first = mostRows, last = 0;
  };
  using Rows = std::array<const double*, mostRows>;

  void put(int lane, const DenseMatrix& columns, double sign, int facet, int first);
  void put(int lane, Column& column, int row, double value);
  Column& column(int facet, int k) { return columns_[std::size_t(facet)][std::size_t(k)]; }
  void pullBack(const CellMatrices& matrices);
  void multiply(const Rows& rows, int f, int g, int first, int count, double* block, int height);

  int facetData_;
  Vector values_;
  std::array<std::array<Column, mostColumns>, 4> columns_; ///< per facet
  Vector own_;                                             ///< per facet mostOwn x mostOwn x lanes
  Vector carriers_; ///< 4 mostCarriers x 4 mostCarriers x lanes, its lower blocks empty
};

} // namespace ndframe
