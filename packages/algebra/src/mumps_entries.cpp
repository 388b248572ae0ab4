#include "mumps_entries.hpp"

namespace ndframe
{

LowerEntries ownLowerEntries(const BlockMatrix& K, const FreeDofs& free)
{
  LowerEntries entries;
  for (int r = 0; r < K.numRows(); ++r)
    for (std::int64_t b = K.rowPtr[std::size_t(r)]; b < K.rowPtr[std::size_t(r) + 1]; ++b)
      for (int i = 0; i < K.dim; ++i)
        for (int j = 0; j < K.dim; ++j) {
          const int row = free.number[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)];
          const int col = free.number[std::size_t(K.colNode(b)) * std::size_t(K.dim) + std::size_t(j)];
          if (row < 0 || col < 0 || col > row)
            continue;
          entries.rows.push_back(row + 1);
          entries.cols.push_back(col + 1);
          entries.values.push_back(
              K.values[(std::size_t(b) * std::size_t(K.dim) + std::size_t(i)) * std::size_t(K.dim) + std::size_t(j)]);
        }
  return entries;
}

std::vector<MUMPS_INT> positionsFromOne(const std::vector<int>& order)
{
  std::vector<MUMPS_INT> positions(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    positions[std::size_t(order[k])] = MUMPS_INT(k) + 1;
  return positions;
}

DenseMatrix matrixOfLowerRows(const Vector& rows, int n)
{
  DenseMatrix A(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      A(i, j) = A(j, i) = rows[std::size_t(i) * std::size_t(n) + std::size_t(j)];
  return A;
}

Vector multiplyLowerRows(const Vector& rows, const Vector& x)
{
  Vector y(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double* row = rows.data() + i * x.size();
    for (std::size_t j = 0; j < i; ++j) {
      y[i] += row[j] * x[j];
      y[j] += row[j] * x[i];
    }
    y[i] += row[i] * x[i];
  }
  return y;
}

} // namespace ndframe
