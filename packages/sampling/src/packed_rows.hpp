#pragma once

#include <cstddef>

#include "ndframe/base/lanes.hpp"

namespace ndframe
{

/// Numbers that are worked on side by side in sums over points and in polynomials. Wider ones are slower where the
/// processor has no such registers.
constexpr std::size_t packLanes = 4;
constexpr std::size_t mostPacks = 7; ///< of a row
using Pack = double __attribute__((vector_size(packLanes * sizeof(double))));

/// sum_m factors[m factorStep] rows[m rowStep + i] for i < packs packLanes.
template <std::size_t packs>
inline __attribute__((always_inline)) void combineRows(const double* factors, std::size_t factorStep,
                                                       const double* rows, std::size_t rowStep, std::size_t count,
                                                       double* result)
{
  Pack sum[packs] = {}, row;
  for (std::size_t m = 0; m < count; ++m)
    for (std::size_t p = 0; p < packs; ++p) {
      load(rows + m * rowStep + p * packLanes, row);
      sum[p] += factors[m * factorStep] * row;
    }
  for (std::size_t p = 0; p < packs; ++p)
    store(sum[p], result + p * packLanes);
}

/// The same for a number of packs, mostPacks at most, that is known at run time.
inline __attribute__((always_inline)) void combineRows(std::size_t packs, const double* factors, std::size_t factorStep,
                                                       const double* rows, std::size_t rowStep, std::size_t count,
                                                       double* result)
{
  switch (packs) {
  case 1:
    return combineRows<1>(factors, factorStep, rows, rowStep, count, result);
  case 2:
    return combineRows<2>(factors, factorStep, rows, rowStep, count, result);
  case 3:
    return combineRows<3>(factors, factorStep, rows, rowStep, count, result);
  case 4:
    return combineRows<4>(factors, factorStep, rows, rowStep, count, result);
  case 5:
    return combineRows<5>(factors, factorStep, rows, rowStep, count, result);
  case 6:
    return combineRows<6>(factors, factorStep, rows, rowStep, count, result);
  default:
    return combineRows<mostPacks>(factors, factorStep, rows, rowStep, count, result);
  }
}

} // namespace ndframe
