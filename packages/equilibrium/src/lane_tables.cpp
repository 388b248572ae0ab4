#include "ndframe/equilibrium/lane_tables.hpp"

#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/cell_forms.hpp"

namespace ndframe
{

NDFRAME_EVERY_PROCESSOR void multiplyTable(const double* table, std::size_t stride, std::size_t rows,
                                           std::size_t columns, const double* x, double* y)
{
  constexpr std::size_t together = 6, lanes = CellForms::lanes;
  for (std::size_t i = 0; i < rows; i += together, table += together * stride, y += together * lanes) {
    DoubleLanes sums[together] = {}, value;
    for (std::size_t j = 0; j < columns; ++j) {
      load(x + j * lanes, value);
#pragma GCC unroll 6
      for (std::size_t k = 0; k < together; ++k)
        sums[k] += table[k * stride + j] * value;
    }
    for (std::size_t k = 0; k < together; ++k)
      store(sums[k], y + k * lanes);
  }
}

} // namespace ndframe
