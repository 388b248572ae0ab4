#include "ndframe/algebra/sparse_columns.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

template <class Entries>
auto placeOf(Entries& column, int row)
{
  return std::lower_bound(column.begin(), column.end(), row,
                          [](const auto& entry, int wanted) { return entry.first < wanted; });
}

} // namespace

SparseColumns::SparseColumns(const DenseMatrix& A) : SparseColumns(A.rows(), A.cols())
{
  for (int j = 0; j < A.cols(); ++j)
    setColumn(j, A.column(j));
}

void SparseColumns::setColumn(int j, const Vector& values)
{
  Column& column = columns_[std::size_t(j)];
  column.clear();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != 0.0)
      column.emplace_back(int(i), values[i]);
}

double& SparseColumns::operator()(int i, int j)
{
  Column& column = columns_[std::size_t(j)];
  auto place = placeOf(column, i);
  if (place == column.end() || place->first != i)
    place = column.insert(place, {i, 0.0});
  return place->second;
}

double SparseColumns::operator()(int i, int j) const
{
  const Column& column = columns_[std::size_t(j)];
  const auto place = placeOf(column, i);
  return place == column.end() || place->first != i ? 0.0 : place->second;
}

Vector SparseColumns::times(const Vector& x) const
{
  Vector y(std::size_t(rows_), 0.0);
  for (std::size_t j = 0; j < columns_.size(); ++j)
    for (const auto& [i, value] : columns_[j])
      y[std::size_t(i)] += value * x[j];
  return y;
}

Vector SparseColumns::transposedTimes(const Vector& x) const
{
  Vector y;
  for (const Column& column : columns_) {
    double sum = 0.0;
    for (const auto& [i, value] : column)
      sum += value * x[std::size_t(i)];
    y.push_back(sum);
  }
  return y;
}

double SparseColumns::magnitude(int j, const Vector& x) const
{
  double sum = 0.0;
  for (const auto& [i, value] : column(j))
    sum += std::abs(value * x[std::size_t(i)]);
  return sum;
}

} // namespace ndframe
