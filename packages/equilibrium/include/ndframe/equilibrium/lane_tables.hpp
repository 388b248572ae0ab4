#pragma once

#include <cstddef>

namespace ndframe
{

/// y_i = sum_j table[i stride + j] x_j for `rows` rows, a multiple of six, and `columns` columns; x and y per number
/// and lane (CellForms::lanes). What a lane gets does not depend on the others.
void multiplyTable(const double* table, std::size_t stride, std::size_t rows, std::size_t columns, const double* x,
                   double* y);
/// The same in single precision.
void multiplyTable(const float* table, std::size_t stride, std::size_t rows, std::size_t columns, const float* x,
                   float* y);

} // namespace ndframe
