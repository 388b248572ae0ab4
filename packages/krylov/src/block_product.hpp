#pragma once

#include "ndframe/algebra/block_matrix.hpp"

namespace ndframe
{

/// y = K x for the rows of K. x: at the nodes that this rank holds; size: of x. Two or three dimensions; with
/// AVX-512 where the processor has it, in three dimensions.
void multiplyBlocks(const BlockMatrix& K, const double* x, std::size_t size, double* y);

} // namespace ndframe
