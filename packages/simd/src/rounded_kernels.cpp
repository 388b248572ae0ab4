#include <cstring>

#include "ndframe/base/lanes.hpp"
#include "ndframe/simd/block_kernels.hpp"

namespace ndframe::block_kernels
{
namespace
{

constexpr std::ptrdiff_t lanes = CellForms::lanes, mostRows = 18;

/// y = factor A x, A of single precision, column by column: `most` rows, or `size` where most is 18, the data of a face
/// at most.
template <std::size_t most>
inline __attribute__((always_inline)) void multiplyUpTo(const void* A, const float* x, std::size_t size, float factor,
                                                        float* y)
{
  float sums[most] = {}, column[most];
  const auto* numbers = static_cast<const char*>(A);
  const std::size_t bytes = (most < 18 ? most : size) * sizeof(float);
  for (std::size_t j = 0; j < size; ++j, numbers += bytes) {
    std::memcpy(column, numbers, bytes);
    for (std::size_t i = 0; i < (most < 18 ? most : size); ++i)
      sums[i] += column[i] * x[j];
  }
  for (std::size_t i = 0; i < size; ++i)
    y[i] = factor * sums[i];
}

typedef float Floats __attribute__((vector_size(sizeof(float) * lanes)));
typedef float HalfFloats __attribute__((vector_size(sizeof(float) * lanes / 2)));

/// y = factor A x, as many rows as nine vectors have numbers; all sums stay in registers.
template <class Numbers>
inline __attribute__((always_inline)) void multiplyNine(const float* A, const float* x, float factor, float* y)
{
  constexpr std::size_t together = 9, width = sizeof(Numbers) / sizeof(float), size = together * width;
  Numbers sums[together] = {}, column;
  for (std::size_t j = 0; j < size; ++j, A += size) {
#pragma GCC unroll 9
    for (std::size_t k = 0; k < together; ++k) {
      load(A + k * width, column);
      sums[k] += column * x[j];
    }
  }
  for (std::size_t k = 0; k < together; ++k)
    store(factor * sums[k], y + k * width);
}

} // namespace

/// Inside, faces have 12 unknowns and edges 6 where displacements are of the second order.
NDFRAME_EVERY_PROCESSOR void multiplyRounded(const void* A, const float* x, std::size_t size, float factor, float* y)
{
  if (size == 12)
    multiplyUpTo<12>(A, x, 12, factor, y);
  else if (size == 6)
    multiplyUpTo<6>(A, x, 6, factor, y);
  else
    multiplyUpTo<18>(A, x, size, factor, y);
}

NDFRAME_EVERY_PROCESSOR void multiplyCell(const float* A, const float* x, std::size_t size, float factor, float* y)
{
  if (size == 9 * lanes)
    multiplyNine<Floats>(A, x, factor, y);
  else
    multiplyNine<HalfFloats>(A, x, factor, y);
}

void multiplyTriangle(const void* triangle, const float* x, std::size_t size, double factor, float* y)
{
  const auto* A = static_cast<const double*>(triangle);
  double sums[mostRows] = {};
  for (std::size_t j = 0; j < size; ++j, ++A) {
    sums[j] += *A * double(x[j]);
    for (std::size_t i = j + 1; i < size; ++i) {
      sums[i] += *++A * double(x[j]);
      sums[j] += *A * double(x[i]);
    }
  }
  for (std::size_t i = 0; i < size; ++i)
    y[i] = float(factor * sums[i]);
}

NDFRAME_EVERY_PROCESSOR void pullBack(const float* inverse, const float* x, std::size_t count, float* y)
{
  Floats F[9], given[3];
  for (std::ptrdiff_t k = 0; k < 9; ++k)
    load(inverse + k * lanes, F[k]);
  for (std::size_t at = 0; at < count; at += 3, x += 3 * lanes, y += 3 * lanes) {
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      load(x + i * lanes, given[i]);
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      store(F[3 * i] * given[0] + F[3 * i + 1] * given[1] + F[3 * i + 2] * given[2], y + i * lanes);
  }
}

NDFRAME_EVERY_PROCESSOR void push(const float* inverse, const float* units, std::size_t count, float* forces)
{
  Floats F[9], given[3], unit;
  load(units, unit);
  for (std::ptrdiff_t k = 0; k < 9; ++k) {
    load(inverse + k * lanes, F[k]);
    F[k] *= unit;
  }
  for (std::size_t at = 0; at < count; at += 3, forces += 3 * lanes) {
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      load(forces + i * lanes, given[i]);
    for (std::ptrdiff_t i = 0; i < 3; ++i)
      store(F[i] * given[0] + F[3 + i] * given[1] + F[6 + i] * given[2], forces + i * lanes);
  }
}

NDFRAME_EVERY_PROCESSOR double dotOf(const float* a, const float* b, std::size_t count)
{
  DoubleLanes sums = {};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Floats x, y;
    load(a + i, x);
    load(b + i, y);
    sums += __builtin_convertvector(x, DoubleLanes) * __builtin_convertvector(y, DoubleLanes);
  }
  double sum = 0.0;
  for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
    sum += sums[lane];
  for (; i < count; ++i)
    sum += double(a[i]) * double(b[i]);
  return sum;
}

} // namespace ndframe::block_kernels
