#include "ndframe/assembly/point_sums.hpp"

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

template <std::size_t packs>
inline __attribute__((always_inline)) void combine(const double* table, std::size_t count, const double* values,
                                                   double* sums)
{
  Pack sum[packs] = {}, t;
  for (std::size_t g = 0; g < count; ++g)
    for (std::size_t p = 0; p < packs; ++p) {
      load(table + (g * packs + p) * lanes, t);
      sum[p] += values[g] * t;
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

NDFRAME_EVERY_PROCESSOR void sumOverPoints(const double* table, std::size_t count, std::size_t stride, double factor,
                                           const double* values, std::size_t size, double* sums)
{
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t i = 0; i < size; ++i) {
      Pack sum{}, t, v;
      for (std::size_t g = 0; g < stride; g += lanes) {
        load(table + row * stride + g, t);
        load(values + i * stride + g, v);
        sum += t * v;
      }
      sums[row * size + i] = factor * total(sum);
    }
}

NDFRAME_EVERY_PROCESSOR void combineRows(const double* table, std::size_t count, std::size_t width,
                                         const double* values, std::size_t stride, std::size_t size, double* sums)
{
  for (std::size_t i = 0; i < size; ++i, values += stride, sums += width)
    switch (width / lanes) {
    case 1:
      combine<1>(table, count, values, sums);
      break;
    case 2:
      combine<2>(table, count, values, sums);
      break;
    case 3:
      combine<3>(table, count, values, sums);
      break;
    default:
      combine<4>(table, count, values, sums);
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
