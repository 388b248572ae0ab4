#pragma once

#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/algebra/sparse_columns.hpp"

namespace ndframe
{

/// X^T A X for an X and a symmetric A with few entries a column: apply(column) is a column of A X, which is left in
/// AX. Every diagonal entry is there, zero or not. Cost: that of the columns and of the columns near them.
template <class Apply>
SymmetricEntries coarseEntries(const SparseColumns& X, const Apply& apply, SparseColumns& AX)
{
  const int n = X.cols();
  AX = SparseColumns(X.rows(), n);
  std::vector<SparseRow> rows; // of X
  rows.resize(std::size_t(X.rows()));
  for (int j = 0; j < n; ++j)
    for (const auto& [row, value] : X.column(j))
      rows[std::size_t(row)].emplace_back(j, value);
  SymmetricEntries coarse;
  coarse.size = n;
  SparseSum products(n);
  for (int j = 0; j < n; ++j) {
    AX.setColumn(j, apply(X.column(j)));
    products.add(j, 0.0);
    for (const auto& [row, value] : AX.column(j))
      products.add(rows[std::size_t(row)], value);
    for (const auto& [i, product] : products.take())
      if (i <= j)
        coarse.add(i, j, product);
  }
  return coarse;
}

} // namespace ndframe
