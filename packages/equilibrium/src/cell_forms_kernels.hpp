#pragma once

#include "ndframe/equilibrium/cell_forms.hpp"

namespace ndframe
{

/// Of solids of degree 2, the largest that CellForms has; what its files in double and in single precision share.
constexpr std::size_t terms = 21; ///< of a compliance
constexpr std::size_t strains = 6, subCells = 4;
constexpr std::size_t bubbles = 18, factorEntries = bubbles * (bubbles + 1) / 2;
constexpr std::size_t mostCoefficients = 240;

/// y := -bb^-1 y of all lanes, from columns of L with the inverses of its diagonal.
template <class Lanes>
inline __attribute__((always_inline)) void solveNegative(const Lanes* L, Lanes* y)
{
  const Lanes* entry = L;
  for (std::size_t b = 0; b < bubbles; ++b) {
    y[b] *= *entry++;
    for (std::size_t i = b + 1; i < bubbles; ++i)
      y[i] -= *entry++ * y[b];
  }
  for (std::size_t b = bubbles; b-- > 0;) {
    entry -= bubbles - b;
    for (std::size_t i = b + 1; i < bubbles; ++i)
      y[b] -= entry[i - b] * y[i];
    y[b] *= entry[0];
  }
  for (std::size_t b = 0; b < bubbles; ++b)
    y[b] = -y[b];
}

} // namespace ndframe
