#pragma once

#include <algorithm>

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// Symmetric matrix by its rows, which have few entries: both triangles, by ascending columns.
class SymmetricRows
{
  template <class Row>
  static auto placeIn(Row& row, int column)
  {
    return std::lower_bound(row.begin(), row.end(), column,
                            [](const auto& entry, int number) { return entry.first < number; });
  }

public:
  explicit SymmetricRows(int size) : rows_(std::size_t(size)) {} ///< zero

  int size() const { return int(rows_.size()); } ///< rows
  /// Adds to entries (i, j) and (j, i).
  void add(int i, int j, double value)
  {
    addTo(i, j, value);
    if (i != j)
      addTo(j, i, value);
  }
  double operator()(int i, int j) const ///< zero where nothing was added
  {
    const SparseRow& row = rows_[std::size_t(i)];
    const auto found = placeIn(row, j);
    return found != row.end() && found->first == j ? found->second : 0.0;
  }
  const std::vector<SparseRow>& rows() const { return rows_; } ///< for product()

private:
  void addTo(int i, int j, double value)
  {
    SparseRow& row = rows_[std::size_t(i)];
    const auto found = placeIn(row, j);
    if (found != row.end() && found->first == j)
      found->second += value;
    else
      row.insert(found, {j, value});
  }

  std::vector<SparseRow> rows_;
};

} // namespace ndframe
