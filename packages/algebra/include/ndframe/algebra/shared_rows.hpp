#pragma once

#include <vector>

#include "ndframe/algebra/block_matrix.hpp"

namespace ndframe
{

/// Per rank the rows (places in K.rows) that it needs of this one.
using RowReaders = std::vector<std::vector<int>>;

/// Rows of K that other ranks hand to this one; `rowsFor`: what this one hands to each of them.
/// Columns stay global. `rows` of the result ascend. Collective.
BlockMatrix receivedRows(const BlockMatrix& K, const RowReaders& rowsFor, const Comm& comm);

} // namespace ndframe
