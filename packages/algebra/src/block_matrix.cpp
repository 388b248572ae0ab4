#include "ndframe/algebra/block_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

const double* BlockMatrix::block(int r, int colNode) const
{
  const auto first = cols.begin() + rowPtr[std::size_t(r)], last = cols.begin() + rowPtr[std::size_t(r) + 1];
  const auto found = std::lower_bound(first, last, colNode);
  if (found == last || *found != colNode)
    return nullptr;
  return values.data() + (found - cols.begin()) * dim * dim;
}

double* BlockMatrix::block(int r, int colNode)
{
  return const_cast<double*>(static_cast<const BlockMatrix&>(*this).block(r, colNode));
}

Vector multiply(const BlockMatrix& K, const Vector& x, const Comm& comm)
{
  NDFRAME_ASSERT(int(x.size()) == K.numDofs(), "shapes do not match");
  const int dim = K.dim;
  Vector y(x.size(), 0.0);
  for (std::size_t r = 0; r < K.rows.size(); ++r) {
    double* yRow = y.data() + std::size_t(K.rows[r]) * std::size_t(dim);
    for (std::int64_t b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b) {
      const double* entry = K.values.data() + b * dim * dim;
      const double* xCol = x.data() + std::size_t(K.cols[std::size_t(b)]) * std::size_t(dim);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          yRow[i] += *entry++ * xCol[j];
    }
  }
  comm.sum(y);
  return y;
}

Vector diagonal(const BlockMatrix& K, const Comm& comm)
{
  Vector d(std::size_t(K.numDofs()), 0.0);
  for (std::size_t r = 0; r < K.rows.size(); ++r) {
    const double* entry = K.block(int(r), K.rows[r]);
    NDFRAME_ASSERT(entry != nullptr, "a row has no diagonal block");
    for (int i = 0; i < K.dim; ++i)
      d[std::size_t(K.rows[r]) * std::size_t(K.dim) + std::size_t(i)] = entry[i * K.dim + i];
  }
  comm.sum(d);
  return d;
}

double meanDiagonal(const BlockMatrix& K, const Comm& comm)
{
  const Vector d = diagonal(K, comm);
  return std::accumulate(d.begin(), d.end(), 0.0) / double(d.size());
}

double productRoundOff(const BlockMatrix& K, const Vector& u, const Comm& comm)
{
  const int dim = K.dim;
  Vector sizes(u.size(), 0.0);
  const double* entry = K.values.data();
  for (std::size_t r = 0; r < K.rows.size(); ++r)
    for (std::int64_t b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          sizes[std::size_t(K.rows[r]) * std::size_t(dim) + std::size_t(i)] +=
              std::abs(*entry++ * u[std::size_t(K.cols[std::size_t(b)]) * std::size_t(dim) + std::size_t(j)]);
  comm.sum(sizes);
  return 16.0 * std::numeric_limits<double>::epsilon() * norm(sizes);
}

} // namespace ndframe
