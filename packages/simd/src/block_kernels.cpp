#include "ndframe/simd/block_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/lanes.hpp"

namespace ndframe::block_kernels
{
namespace
{

constexpr std::ptrdiff_t lanes = CellForms::lanes, mostRows = 18, mostOwn = 12, linear = CellForms::linear;

inline __attribute__((always_inline)) void get(const double* values, std::ptrdiff_t entry, DoubleLanes& value)
{
  load(values + entry * lanes, value);
}

inline __attribute__((always_inline)) void put(const DoubleLanes& value, double* values, std::ptrdiff_t entry)
{
  store(value, values + entry * lanes);
}

inline __attribute__((always_inline)) void takeRoot(DoubleLanes& x)
{
  for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
    x[lane] = std::sqrt(x[lane]);
}

/// given := F^-T given F^-1, 3 x 3, [row][column].
inline __attribute__((always_inline)) void turnBlock(const DoubleLanes* F, DoubleLanes (*given)[3])
{
  DoubleLanes half[3][3];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      half[i][j] = given[i][0] * F[j] + given[i][1] * F[3 + j] + given[i][2] * F[6 + j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      given[i][j] = F[i] * half[0][j] + F[3 + i] * half[1][j] + F[6 + i] * half[2][j];
}

/// Rows by wrenches about a face's centre become rows by wrenches about an edge's middle.
inline __attribute__((always_inline)) void moveRows(DoubleLanes (*X)[6], const DoubleLanes* arm,
                                                    const DoubleLanes& length)
{
  for (std::size_t k = 0; k < 6; ++k) {
    const DoubleLanes M[3] = {X[3][k], X[4][k], X[5][k]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
      X[i][k] += M[j] * arm[l] - M[l] * arm[j];
      X[3 + i][k] = length * M[i];
    }
  }
}

/// The same of columns.
inline __attribute__((always_inline)) void moveColumns(DoubleLanes (*X)[6], const DoubleLanes* arm,
                                                       const DoubleLanes& length)
{
  for (std::size_t k = 0; k < 6; ++k) {
    const DoubleLanes M[3] = {X[k][3], X[k][4], X[k][5]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
      X[k][i] += M[j] * arm[l] - M[l] * arm[j];
      X[k][3 + i] = length * M[i];
    }
  }
}

} // namespace

NDFRAME_EVERY_PROCESSOR void turnSymmetric(const double* triangle, const double* inverse, int size, double* A)
{
  DoubleLanes F[9], block[3][3];
  for (std::ptrdiff_t k = 0; k < 9; ++k)
    get(inverse, k, F[k]);
  const auto placeOf = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
    const std::ptrdiff_t row = std::max(i, j), column = std::min(i, j);
    return column * size - column * (column - 1) / 2 + row - column;
  };
  for (std::ptrdiff_t col = 0; col < size; col += 3)
    for (std::ptrdiff_t row = col; row < size; row += 3) {
      for (std::ptrdiff_t i = 0; i < 3; ++i)
        for (std::ptrdiff_t j = 0; j < 3; ++j)
          get(triangle, placeOf(row + i, col + j), block[i][j]);
      turnBlock(F, block);
      for (std::ptrdiff_t i = 0; i < 3; ++i)
        for (std::ptrdiff_t j = 0; j < 3; ++j) {
          put(block[i][j], A, (col + j) * mostRows + row + i);
          put(block[i][j], A, (row + i) * mostRows + col + j);
        }
    }
}

NDFRAME_EVERY_PROCESSOR void turn(const double* given, const double* inverse, double* A)
{
  DoubleLanes F[9], block[3][3];
  for (std::ptrdiff_t k = 0; k < 9; ++k)
    get(inverse, k, F[k]);
  for (std::ptrdiff_t col = 0; col < linear; col += 3)
    for (std::ptrdiff_t row = 0; row < linear; row += 3) {
      for (std::ptrdiff_t i = 0; i < 3; ++i)
        for (std::ptrdiff_t j = 0; j < 3; ++j)
          get(given, (col + j) * linear + row + i, block[i][j]);
      turnBlock(F, block);
      for (std::ptrdiff_t i = 0; i < 3; ++i)
        for (std::ptrdiff_t j = 0; j < 3; ++j)
          put(block[i][j], A, (col + j) * linear + row + i);
    }
}

NDFRAME_EVERY_PROCESSOR void findCarrier(const double* arms, const double* size, double* carrier)
{
  DoubleLanes r[2][3], along[3], across[3], normal[3], second = {}, square = {}, rest = {};
  for (std::size_t i = 0; i < 3; ++i) {
    get(arms, std::ptrdiff_t(i), r[0][i]);
    get(arms, std::ptrdiff_t(i) + 3, r[1][i]);
    square += r[0][i] * r[0][i];
  }
  takeRoot(square);
  const DoubleLanes first = square;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = r[0][i] / first;
    second += r[1][i] * along[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    across[i] = r[1][i] - second * along[i];
    rest += across[i] * across[i];
  }
  takeRoot(rest);
  DoubleLanes scale;
  get(size, 0, scale);
  const DoubleLanes height = rest;
  for (std::size_t i = 0; i < 3; ++i)
    across[i] /= height;
  for (std::size_t i = 0; i < 3; ++i)
    normal[i] = along[(i + 1) % 3] * across[(i + 2) % 3] - along[(i + 2) % 3] * across[(i + 1) % 3];
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = std::ptrdiff_t(i) * 3 + std::ptrdiff_t(m);
      const DoubleLanes twist = 0.5 * scale * normal[m];
      const DoubleLanes T2 = (scale * along[m] * normal[i] - twist * along[i]) / height;
      const DoubleLanes T1 = (twist * across[i] - scale * across[m] * normal[i] - second * T2) / first;
      put(T1, carrier, row);
      put(T2, carrier, row + 9);
    }
}

namespace
{

/// The linear tractions without wrench, T_1 and T_2 of each.
NDFRAME_EVERY_PROCESSOR void findOwnColumns(const double* arms, DoubleLanes (*columns)[6])
{
  DoubleLanes r[2][3], square[2] = {};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      load(arms + (3 * k + i) * std::size_t(lanes), r[k][i]);
      square[k] += r[k][i] * r[k][i];
    }
  DoubleLanes length[3] = {square[0], square[1], square[0] + square[1]};
  for (DoubleLanes& value : length)
    takeRoot(value);
  for (std::size_t i = 0; i < 3; ++i) {
    columns[0][i] = r[0][i] / length[0];
    columns[1][3 + i] = r[1][i] / length[1];
    columns[2][i] = r[1][i] / length[2];
    columns[2][3 + i] = r[0][i] / length[2];
  }
}

} // namespace

NDFRAME_EVERY_PROCESSOR void findOwn(const double* A, const double* arms, int facetData, double* own)
{
  DoubleLanes columns[3][6] = {}, product[mostRows][3];
  findOwnColumns(arms, columns);
  const std::ptrdiff_t count = 3 + facetData - linear;
  for (std::ptrdiff_t row = 3; row < facetData; ++row) {
    DoubleLanes entries[6];
    for (std::ptrdiff_t j = 0; j < 6; ++j)
      get(A, (j + 3) * mostRows + row, entries[j]);
    for (std::size_t k = 0; k < 3; ++k) {
      DoubleLanes sum = {};
      for (std::size_t j = k == 1 ? 3 : 0; j < (k == 0 ? 3 : 6); ++j)
        sum += entries[j] * columns[k][j];
      product[row][k] = sum;
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::ptrdiff_t l = 0; l < count; ++l) {
      DoubleLanes sum = {};
      if (l < 3)
        for (std::size_t i = 0; i < 6; ++i)
          sum += columns[l][i] * product[i + 3][k];
      else
        sum = product[l + linear - 3][k];
      put(sum, own, std::ptrdiff_t(k) * mostOwn + l);
      put(sum, own, l * mostOwn + std::ptrdiff_t(k));
    }
  for (std::ptrdiff_t k = 3; k < count; ++k)
    std::copy_n(A + ((k + linear - 3) * mostRows + linear) * lanes, (count - 3) * lanes,
                own + (k * mostOwn + 3) * lanes);
}

NDFRAME_EVERY_PROCESSOR void multiplyCarriers(const double* A, std::ptrdiff_t stride, const double* left,
                                              const double* right, double* product)
{
  DoubleLanes K[18], half[linear][6]; // A times the right columns
  for (std::ptrdiff_t k = 0; k < 18; ++k)
    get(right, k, K[k]);
  for (std::ptrdiff_t row = 0; row < linear; ++row) {
    for (std::ptrdiff_t k = 0; k < 3; ++k)
      get(A, k * stride + row, half[row][k]);
    for (std::size_t m = 0; m < 3; ++m)
      half[row][3 + m] = DoubleLanes{};
    for (std::ptrdiff_t j = 0; j < 6; ++j) {
      DoubleLanes entry;
      get(A, (j + 3) * stride + row, entry);
      for (std::ptrdiff_t m = 0; m < 3; ++m)
        half[row][3 + m] += entry * K[j * 3 + m];
    }
  }
  for (std::ptrdiff_t k = 0; k < 18; ++k)
    get(left, k, K[k]);
  for (std::ptrdiff_t k = 0; k < 6; ++k)
    for (std::ptrdiff_t l = 0; l < 6; ++l) {
      DoubleLanes sum = {};
      if (l < 3)
        sum = half[l][k];
      for (std::ptrdiff_t i = 0; i < 6 && l >= 3; ++i)
        sum += K[i * 3 + l - 3] * half[i + 3][k];
      put(sum, product, k * 6 + l);
    }
}

NDFRAME_EVERY_PROCESSOR void findEdge(std::array<const double*, 3> parts, std::array<const double*, 2> arms,
                                      std::array<const double*, 2> lengths, double* block)
{
  DoubleLanes arm[2][3], length[2], sum[6][6] = {}, X[6][6];
  for (std::size_t side = 0; side < 2; ++side) {
    get(lengths[side], 0, length[side]);
    for (std::size_t i = 0; i < 3; ++i)
      get(arms[side], std::ptrdiff_t(i), arm[side][i]);
  }
  for (std::size_t part = 0; part < 3; ++part) {
    const std::size_t row = part == 0 ? 0 : 1, col = part == 1 ? 1 : 0;
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < 6; ++i)
        load(parts[part] + (j * 6 + i) * std::size_t(lanes), X[i][j]);
    moveRows(X, arm[row], length[row]);
    moveColumns(X, arm[col], length[col]);
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < 6; ++i)
        sum[i][j] += part < 2 ? X[i][j] : -(X[i][j] + X[j][i]);
  }
  for (std::size_t j = 0; j < 6; ++j)
    for (std::size_t i = 0; i < 6; ++i)
      store(sum[i][j], block + (j * 6 + i) * std::size_t(lanes));
}

/// Sweeps pivot by pivot, in any order for matrices that are positive, to -A^-1; all matrices between are symmetric.
NDFRAME_EVERY_PROCESSOR bool invert(double* A, int size, double least)
{
  DoubleLanes largest = {}, column[mostRows], entry;
  bool isPositive = true;
  for (std::ptrdiff_t k = 0; k < size; ++k)
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
      largest[lane] = std::max(largest[lane], A[(k * size + k) * lanes + lane]);
  for (std::ptrdiff_t k = 0; k < size; ++k) {
    for (std::ptrdiff_t i = 0; i < size; ++i)
      get(A, k * size + i, column[i]);
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
      isPositive = isPositive && column[k][lane] > least * largest[lane];
    const DoubleLanes inverse = 1.0 / column[k];
    for (std::ptrdiff_t j = 0; j < size; ++j) {
      if (j == k)
        continue;
      const DoubleLanes factor = column[j] * inverse;
      for (std::ptrdiff_t i = 0; i < size; ++i) {
        get(A, j * size + i, entry);
        put(entry - column[i] * factor, A, j * size + i);
      }
      put(factor, A, j * size + k);
    }
    for (std::ptrdiff_t i = 0; i < size; ++i)
      put(column[i] * inverse, A, k * size + i);
    put(-inverse, A, k * size + k);
  }
  for (std::ptrdiff_t k = 0; k < std::ptrdiff_t(size) * size * lanes; ++k)
    A[k] = -A[k];
  return isPositive;
}

} // namespace ndframe::block_kernels
