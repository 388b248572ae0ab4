#include "substitution.hpp"

#include <algorithm>

#include "ndframe/sampling/point_sums.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t matrixStride = mostPacks * packLanes;
static_assert(BoxPolynomial::highest < matrixStride, "a row has all powers");

/// The padded rows of coefficients with the same j and k, i + j + k < rows.
struct Rows
{
  double* first;
  std::size_t slices, rows, stride;

  double* at(std::size_t k, std::size_t j) const { return first + (k * rows + j) * stride; }
};

enum class Along
{
  I,
  J,
  K
};

/// Replaces one coordinate. Along j and k a row takes up itself and later ones, which are as they were.
template <Along along>
inline __attribute__((always_inline)) void replace(const Rows& b, const double* matrix)
{
  for (std::size_t k = 0; k < b.slices; ++k)
    for (std::size_t j = 0; j + k < b.rows; ++j) {
      double* const row = b.at(k, j);
      const std::size_t count = b.rows - j - k, packs = (count + packLanes - 1) / packLanes;
      if constexpr (along == Along::I)
        combineRows(packs, row, 1, matrix, matrixStride, count, row);
      else {
        constexpr bool ofSlices = along == Along::K;
        combineRows(packs, matrix + (ofSlices ? k : j) * (matrixStride + 1), matrixStride, row,
                    ofSlices ? b.rows * b.stride : b.stride, count, row);
      }
    }
}

NDFRAME_EVERY_PROCESSOR void replaceAll(const Rows& b, const std::array<const SubstitutionMatrix*, 3>& xyz)
{
  replace<Along::I>(b, xyz[0]->front().data());
  replace<Along::J>(b, xyz[1]->front().data());
  if (b.slices > 1)
    replace<Along::K>(b, xyz[2]->front().data());
}

} // namespace

void substitute(PlacedPolynomial& polynomial, const std::array<const SubstitutionMatrix*, 3>& xyz,
                std::vector<double>& rows)
{
  const auto count = std::size_t(polynomial.degree) + 1, slices = polynomial.place.dim == 3 ? count : 1;
  const std::size_t stride = paddedCount(int(count));
  rows.resize(slices * count * stride);
  const Rows all{rows.data(), slices, count, stride};
  const double* given = polynomial.coefficients.data();
  for (std::size_t k = 0; k < slices; ++k)
    for (std::size_t j = 0; j + k < count; given += count - j - k, ++j)
      std::fill(std::copy_n(given, count - j - k, all.at(k, j)), all.at(k, j) + stride, 0.0);
  replaceAll(all, xyz);
  double* next = polynomial.coefficients.data();
  for (std::size_t k = 0; k < slices; ++k)
    for (std::size_t j = 0; j + k < count; ++j)
      next = std::copy_n(all.at(k, j), count - j - k, next);
}

} // namespace ndframe
