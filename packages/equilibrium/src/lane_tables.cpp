#include "ndframe/equilibrium/lane_tables.hpp"

#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/cell_forms.hpp"

namespace ndframe
{

namespace
{

constexpr std::size_t lanes = CellForms::lanes;

typedef float Floats __attribute__((vector_size(sizeof(float) * lanes)));

template <class Lanes, class Number>
inline __attribute__((always_inline)) void multiply(const Number* table, std::size_t stride, std::size_t rows,
                                                    std::size_t columns, const Number* x, Number* y)
{
  constexpr std::size_t together = 6;
  for (std::size_t i = 0; i < rows; i += together, table += together * stride, y += together * lanes) {
    Lanes sums[together] = {}, value;
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

} // namespace

NDFRAME_EVERY_PROCESSOR void multiplyTable(const double* table, std::size_t stride, std::size_t rows,
                                           std::size_t columns, const double* x, double* y)
{
  multiply<DoubleLanes>(table, stride, rows, columns, x, y);
}

NDFRAME_EVERY_PROCESSOR void multiplyTable(const float* table, std::size_t stride, std::size_t rows,
                                           std::size_t columns, const float* x, float* y)
{
  multiply<Floats>(table, stride, rows, columns, x, y);
}

} // namespace ndframe
