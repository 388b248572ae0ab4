#include "ndframe/assembly/point_sums.hpp"

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = 4;
using Pack = double __attribute__((vector_size(lanes * sizeof(double))));

inline __attribute__((always_inline)) double total(const Pack& sum)
{
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Of one component.
template <std::size_t packs>
inline __attribute__((always_inline)) void sumUp(const double* table, std::size_t points, const double* values,
                                                 std::size_t size, double* sums)
{
  Pack sum[packs] = {}, t;
  for (std::size_t g = 0; g < points; ++g)
    for (std::size_t p = 0; p < packs; ++p) {
      load(table + (g * packs + p) * lanes, t);
      sum[p] += values[g * size] * t;
    }
  for (std::size_t p = 0; p < packs; ++p)
    store(sum[p], sums + p * lanes);
}

} // namespace

std::size_t paddedCount(int points)
{
  return (std::size_t(points) + lanes - 1) / lanes * lanes;
}

void rowsOf(const Samples& samples, int size, std::vector<double>& rows)
{
  const std::size_t points = std::size_t(samples.rule.size()), stride = paddedCount(samples.rule.size());
  rows.resize(stride * std::size_t(size));
  for (std::size_t i = 0; i < std::size_t(size); ++i) {
    double* row = rows.data() + i * stride;
    for (std::size_t g = 0; g < points; ++g)
      row[g] = samples.values[g * std::size_t(size) + i];
    std::fill(row + points, row + stride, 0.0);
  }
}

NDFRAME_EVERY_PROCESSOR void sumOverPoints(const double* table, int points, int count, double factor,
                                           const double* values, std::size_t size, double* sums)
{
  const std::size_t packs = paddedCount(count) / lanes;
  NDFRAME_ASSERT(packs <= 4, "sums for 16 functions at most");
  double ofComponent[4 * lanes];
  for (std::size_t i = 0; i < size; ++i) {
    switch (packs) {
    case 1:
      sumUp<1>(table, std::size_t(points), values + i, size, ofComponent);
      break;
    case 2:
      sumUp<2>(table, std::size_t(points), values + i, size, ofComponent);
      break;
    case 3:
      sumUp<3>(table, std::size_t(points), values + i, size, ofComponent);
      break;
    default:
      sumUp<4>(table, std::size_t(points), values + i, size, ofComponent);
    }
    for (std::size_t k = 0; k < std::size_t(count); ++k)
      sums[k * size + i] = factor * ofComponent[k];
  }
}

NDFRAME_EVERY_PROCESSOR double squareOfRest(const double* table, std::size_t count, std::size_t stride,
                                            const double* factors, const double* values, std::size_t size,
                                            const double* weights)
{
  Pack square{};
  for (std::size_t g = 0; g < stride; g += lanes) {
    Pack weight, t, v;
    load(weights + g, weight);
    for (std::size_t i = 0; i < size; ++i) {
      load(values + i * stride + g, v);
      for (std::size_t k = 0; k < count; ++k) {
        load(table + k * stride + g, t);
        v -= factors[k * size + i] * t;
      }
      square += weight * v * v;
    }
  }
  return total(square);
}

} // namespace ndframe
