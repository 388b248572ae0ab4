#pragma once

#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// As many rows of A as it has columns, chosen so that A x = 0 on them leaves x = 0 as clearly as possible: the pivots
/// of an orthogonalisation of the rows, in their order. Fewer where the columns depend on each other exactly.
std::vector<int> pivotRows(DenseMatrix A);

} // namespace ndframe
