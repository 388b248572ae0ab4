#pragma once

#include <functional>
#include <vector>

#include "ndframe/algebra/block_matrix.hpp"

namespace ndframe
{

/// Per node, other nodes whose ranks need its row; any order, repetitions allowed.
using RowReaders = std::function<std::vector<int>(int node)>;

/// Rows of K that other ranks hand to this one, which has the row of one of their readers. Columns stay global. `rows`
/// of the result ascend. Collective.
BlockMatrix receivedRows(const BlockMatrix& K, const RowReaders& readers, const Comm& comm);

} // namespace ndframe
