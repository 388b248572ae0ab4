#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Columns and coefficients of a row, or rows and entries of a vector, that is mostly zero.
using SparseRow = std::vector<std::pair<int, double>>;

/// The rows of a matrix that is given by its rows, as rows of its transpose.
inline std::vector<SparseRow> transposed(const std::vector<SparseRow>& rows, int columns)
{
  std::vector<SparseRow> result;
  result.resize(std::size_t(columns));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result[std::size_t(j)].emplace_back(int(i), value);
  return result;
}

/// A vector in which few entries are summed up again and again: clearing and reading cost what was written.
class SparseSum
{
public:
  explicit SparseSum(int size) : values_(std::size_t(size), 0.0), isWritten_(std::size_t(size), 0) {} ///< zero

  /// Adds to entry i < size.
  void add(int i, double value)
  {
    if (!isWritten_[std::size_t(i)]) {
      isWritten_[std::size_t(i)] = 1;
      written_.push_back(i);
    }
    values_[std::size_t(i)] += value;
  }
  /// Adds factor times these entries.
  void add(const SparseRow& row, double factor)
  {
    for (const auto& [i, value] : row)
      add(i, factor * value);
  }
  /// The sum, by ascending numbers; it is zero again afterwards.
  SparseRow take()
  {
    std::sort(written_.begin(), written_.end());
    SparseRow result;
    for (const int i : written_) {
      result.emplace_back(i, std::exchange(values_[std::size_t(i)], 0.0));
      isWritten_[std::size_t(i)] = 0;
    }
    written_.clear();
    return result;
  }

private:
  Vector values_;
  std::vector<char> isWritten_;
  std::vector<int> written_;
};

/// A x of a matrix that is given by its rows.
inline Vector product(const std::vector<SparseRow>& rows, const Vector& x)
{
  Vector result(rows.size(), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result[i] += value * x[std::size_t(j)];
  return result;
}

/// A^T x of such a matrix with so many columns.
inline Vector transposedProduct(const std::vector<SparseRow>& rows, const Vector& x, int columns)
{
  Vector result(std::size_t(columns), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result[std::size_t(j)] += value * x[i];
  return result;
}

/// A B, B with so many columns.
inline std::vector<SparseRow> product(const std::vector<SparseRow>& A, const std::vector<SparseRow>& B, int columns)
{
  std::vector<SparseRow> result;
  SparseSum sum(columns);
  for (const SparseRow& row : A) {
    for (const auto& [k, share] : row)
      sum.add(B[std::size_t(k)], share);
    result.push_back(sum.take());
  }
  return result;
}

} // namespace ndframe
