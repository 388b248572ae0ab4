#include "ndframe/sampling/point_sums.hpp"

#include "ndframe/base/diagnostics.hpp"
#include "packed_rows.hpp"

namespace ndframe
{
namespace
{

inline __attribute__((always_inline)) double total(const Pack& sum)
{
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

} // namespace

std::size_t paddedCount(int points)
{
  return (std::size_t(points) + packLanes - 1) / packLanes * packLanes;
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
  const std::size_t row = paddedCount(count);
  NDFRAME_ASSERT(row <= mostPacks * packLanes, "sums for 28 functions at most");
  double ofComponent[mostPacks * packLanes];
  for (std::size_t i = 0; i < size; ++i) {
    combineRows(row / packLanes, values + i, size, table, row, std::size_t(points), ofComponent);
    for (std::size_t k = 0; k < std::size_t(count); ++k)
      sums[k * size + i] = factor * ofComponent[k];
  }
}

NDFRAME_EVERY_PROCESSOR double squareOfRest(const double* table, std::size_t count, std::size_t stride,
                                            const double* factors, const double* values, std::size_t size,
                                            const double* weights)
{
  Pack square{};
  for (std::size_t g = 0; g < stride; g += packLanes) {
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
