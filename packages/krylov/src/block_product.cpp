#include "block_product.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ndframe
{

namespace
{

/// One block row: y += sum of blocks times x, without what an instruction set offers.
template <int dim>
inline void multiplyRow(const double* entry, const int* column, const int* end, const double* x, double* y)
{
  double sum[dim] = {};
  constexpr std::ptrdiff_t block = std::ptrdiff_t(dim) * dim;
  for (; column != end; ++column, entry += block) {
    const double* value = x + std::ptrdiff_t(*column) * dim;
    for (std::ptrdiff_t i = 0; i < dim; ++i) { // a block's part by itself: sums of all blocks would wait for each other
      double part = entry[i * dim] * value[0];
      for (std::ptrdiff_t j = 1; j < dim; ++j)
        part += entry[i * dim + j] * value[j];
      sum[i] += part;
    }
  }
  for (int i = 0; i < dim; ++i)
    y[i] = sum[i];
}

template <int dim>
void multiplyPortably(const BlockMatrix& K, const double* x, double* y)
{
  const int* const columns = K.cols.data();
  for (std::size_t r = 0; r < std::size_t(K.numRows()); ++r)
    multiplyRow<dim>(K.values.data() + K.rowPtr[r] * dim * dim, columns + K.rowPtr[r], columns + K.rowPtr[r + 1], x,
                     y + r * dim);
}

#if defined(__x86_64__)

/// Eight of a block's nine entries at a time, two sums of them side by side. Blocks whose x ends less than eight
/// numbers before the end of x go by themselves: eight are read.
__attribute__((target("avx512f"))) void multiplyByEight(const BlockMatrix& K, const double* x, std::size_t size,
                                                        double* y)
{
  const __m512i pattern = _mm512_setr_epi64(0, 1, 2, 0, 1, 2, 0, 1);
  constexpr __mmask8 all = 0xff;      // the form without a mask makes g++ 12 warn of its own header
  const int last = int(size / 3) - 3; // node whose eight numbers are there
  const double* entry = K.values.data();
  for (std::size_t r = 0; r < std::size_t(K.numRows()); ++r) {
    const int *column = K.cols.data() + K.rowPtr[r], *end = K.cols.data() + K.rowPtr[r + 1];
    __m512d even = _mm512_setzero_pd(), odd = _mm512_setzero_pd();
    double corner = 0.0, otherCorner = 0.0, rest[3], sum[8];
    for (; end - column >= 2 && column[0] <= last && column[1] <= last; column += 2, entry += 18) {
      const double *first = x + std::ptrdiff_t(column[0]) * 3, *second = x + std::ptrdiff_t(column[1]) * 3;
      even = _mm512_fmadd_pd(_mm512_loadu_pd(entry), _mm512_maskz_permutexvar_pd(all, pattern, _mm512_loadu_pd(first)),
                             even);
      odd = _mm512_fmadd_pd(_mm512_loadu_pd(entry + 9),
                            _mm512_maskz_permutexvar_pd(all, pattern, _mm512_loadu_pd(second)), odd);
      corner += entry[8] * first[2];
      otherCorner += entry[17] * second[2];
    }
    multiplyRow<3>(entry, column, end, x, rest);
    entry += (end - column) * 9;
    _mm512_storeu_pd(sum, _mm512_add_pd(even, odd));
    y[3 * r] = sum[0] + sum[1] + sum[2] + rest[0];
    y[3 * r + 1] = sum[3] + sum[4] + sum[5] + rest[1];
    y[3 * r + 2] = sum[6] + sum[7] + corner + otherCorner + rest[2];
  }
}

bool takesEight()
{
  static const bool takes = __builtin_cpu_supports("avx512f");
  return takes;
}

#else

bool takesEight()
{
  return false;
}

void multiplyByEight(const BlockMatrix&, const double*, std::size_t, double*) {}

#endif

} // namespace

void multiplyBlocks(const BlockMatrix& K, const double* x, std::size_t size, double* y)
{
  if (K.dim == 2)
    multiplyPortably<2>(K, x, y);
  else if (takesEight())
    multiplyByEight(K, x, size, y);
  else
    multiplyPortably<3>(K, x, y);
}

} // namespace ndframe
