#include "cell_blocks.hpp"

#include <algorithm>

#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::ptrdiff_t lanes = CellForms::lanes;

/// Where an entry of matrices side by side begins that are stored in rows, or columns, of this length.
std::ptrdiff_t lanesAt(std::ptrdiff_t line, std::ptrdiff_t length, std::ptrdiff_t place)
{
  return (line * length + place) * lanes;
}

/// F^-1 applied to `count` vectors.
NDFRAME_EVERY_PROCESSOR void pullBackLanes(const double* inverse, double* vectors, int count)
{
  DoubleLanes F[9], given[3];
  for (int k = 0; k < 9; ++k)
    load(inverse + k * lanes, F[k]);
  for (int k = 0; k < count; ++k, vectors += 3 * lanes) {
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      load(vectors + i * lanes, given[i]);
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      store(F[3 * i] * given[0] + F[3 * i + 1] * given[1] + F[3 * i + 2] * given[2], vectors + i * lanes);
  }
}

/// result = x^T y, of the entries first .. last.
inline __attribute__((always_inline)) void dotLanes(const double* x, const double* y, int first, int last,
                                                    double* result)
{
  DoubleLanes sum{}, a, b;
  for (int i = first; i < last; ++i) {
    load(x + i * lanes, a);
    load(y + i * lanes, b);
    sum += a * b;
  }
  store(sum, result);
}

/// result[i] = sum_j rows[i][j] x[j]
NDFRAME_EVERY_PROCESSOR void multiplyRows(const double* const* rows, int count, const double* x, int first, int last,
                                          double* result)
{
  for (int i = 0; i < count; ++i)
    dotLanes(rows[i], x, first, last, result + i * lanes);
}

NDFRAME_EVERY_PROCESSOR void multiplyPair(const double* x, const double* y, int first, int last, double* result)
{
  dotLanes(x, y, first, last, result);
}

} // namespace

CellBlocks::CellBlocks(int facetData)
    : facetData_(facetData), values_(std::size_t(4) * mostColumns * mostRows * lanes, 0.0),
      own_(std::size_t(4) * mostOwn * mostOwn * lanes, 0.0),
      carriers_(std::size_t(16) * mostCarriers * mostCarriers * lanes, 0.0)
{
  double* values = values_.data();
  for (auto& facet : columns_)
    for (Column& column : facet) {
      column.values = values;
      values += mostRows * lanes;
    }
}

void CellBlocks::clear()
{
  for (auto& facet : columns_)
    for (Column& column : facet) {
      if (column.first < column.last)
        std::fill(column.values + column.first * lanes, column.values + column.last * lanes, 0.0);
      column.first = mostRows;
      column.last = 0;
    }
}

void CellBlocks::put(int lane, int facet, const StressFace& face, std::size_t side)
{
  NDFRAME_ASSERT(face.numOwn() <= mostOwn && face.free->carrier.cols() <= mostCarriers, "faces of degree 1 or 2");
  if (side == 1 && face.turned.rows() > 0) {
    put(lane, face.onSide(side, face.allOwn()), 1.0, facet, 0);
    put(lane, face.onSide(side, face.free->carrier), 1.0, facet, mostOwn);
    return;
  }
  const double sign = side == 0 ? 1.0 : -1.0;
  put(lane, face.free->own, sign, facet, 0);
  for (int k = 0; k < face.free->higher; ++k)
    put(lane, column(facet, face.free->own.cols() + k), face.free->own.rows() + k, sign);
  put(lane, face.free->carrier, sign, facet, mostOwn);
}

void CellBlocks::put(int lane, const DenseMatrix& columns, double sign, int facet, int first)
{
  for (int k = 0; k < columns.cols(); ++k)
    for (int i = 0; i < columns.rows(); ++i)
      if (columns(i, k) != 0.0)
        put(lane, column(facet, first + k), i, sign * columns(i, k));
}

void CellBlocks::put(int lane, Column& column, int row, double value)
{
  column.values[row * lanes + lane] = value;
  column.first = std::min(column.first, row - row % 3); // whole vectors
  column.last = std::max(column.last, row - row % 3 + 3);
}

void CellBlocks::pullBack(const CellMatrices& matrices)
{
  std::array<double, std::size_t(9) * lanes> inverse{};
  for (int lane = 0; lane < matrices.count; ++lane)
    for (std::size_t k = 0; k < 9; ++k)
      inverse[k * lanes + std::size_t(lane)] = matrices.maps[lane].inverse[k];
  for (auto& facet : columns_)
    for (Column& column : facet)
      if (column.first < column.last)
        pullBackLanes(inverse.data(), column.values + std::ptrdiff_t(column.first) * lanes,
                      (column.last - column.first) / 3);
}

/// block(l, k) = x_l^T A_fg x_k for `count` columns of both facets from `first` on; where the facets are the same, for
/// both orders of l and k. Columns of the block are `height` apart.
void CellBlocks::multiply(const Rows& rows, int f, int g, int first, int count, double* block, int height)
{
  std::array<double, std::size_t(mostRows) * lanes> product;
  for (int k = 0; k < count; ++k) {
    const Column& right = column(g, first + k);
    if (right.first >= right.last)
      continue;
    multiplyRows(rows.data(), facetData_, right.values, right.first, right.last, product.data());
    for (int l = 0; l < (f == g ? k + 1 : count); ++l) {
      const Column& left = column(f, first + l);
      double* entry = block + lanesAt(k, height, l);
      multiplyPair(left.values, product.data(), left.first, left.last, entry);
      if (f == g)
        std::copy_n(entry, lanes, block + lanesAt(l, height, k));
    }
  }
}

void CellBlocks::compute(const CellMatrices& matrices)
{
  constexpr int height = 4 * mostCarriers;
  pullBack(matrices);
  Vector full(std::size_t(mostRows) * mostRows * lanes, 0.0);
  Rows rows{};
  const auto carriers = [&](std::ptrdiff_t f, std::ptrdiff_t g) {
    return carriers_.data() + lanesAt(mostCarriers * g, height, mostCarriers * f);
  };
  for (int f = 0; f < 4; ++f) {
    for (int i = 0; i < facetData_; ++i)
      for (int j = 0; j < facetData_; ++j)
        std::copy_n(matrices.entry(f * facetData_ + std::max(i, j), f * facetData_ + std::min(i, j)), lanes,
                    full.data() + lanesAt(i, mostRows, j));
    for (int i = 0; i < mostRows; ++i)
      rows[std::size_t(i)] = full.data() + lanesAt(i, mostRows, 0);
    multiply(rows, f, f, 0, mostOwn, own_.data() + lanesAt(f * mostOwn, mostOwn, 0), mostOwn);
    multiply(rows, f, f, mostOwn, mostCarriers, carriers(f, f), height);
    for (int g = f + 1; g < 4; ++g) {
      for (int i = 0; i < facetData_; ++i)
        rows[std::size_t(i)] = matrices.entry(g * facetData_, f * facetData_ + i);
      multiply(rows, f, g, mostOwn, mostCarriers, carriers(f, g), height);
    }
  }
}

void CellBlocks::addOwn(int lane, int facet, int size, Vector& values) const
{
  const double* block = own_.data() + lanesAt(facet * mostOwn, mostOwn, 0) + lane;
  for (int k = 0; k < size; ++k)
    for (int l = 0; l < size; ++l)
      values.push_back(block[lanesAt(k, mostOwn, l)]);
}

DenseMatrix CellBlocks::ofCarriers(int lane) const
{
  constexpr int size = 4 * mostCarriers;
  DenseMatrix W(size, size);
  for (int k = 0; k < size; ++k)
    for (int l = 0; l < size; ++l) {
      const bool isUpper = l / mostCarriers <= k / mostCarriers;
      W(l, k) = *(carriers_.data() + (isUpper ? lanesAt(k, size, l) : lanesAt(l, size, k)) + lane);
    }
  return W;
}

} // namespace ndframe
