#pragma once

#include <functional>
#include <vector>

#include "ndframe/algebra/block_matrix.hpp"

namespace ndframe
{

/// Per block row of this rank, nodes (numbers of all ranks) whose ranks need it; any order, repetitions and own nodes
/// allowed.
using RowReaders = std::function<std::vector<IndexMap::Global>(int row)>;

/// Rows of K that other ranks hand to this one, which has the row of one of their readers. The nodes of the result are
/// those that the rows belong to, ascending, as owned ones, and their columns. Collective.
BlockMatrix receivedRows(const BlockMatrix& K, const RowReaders& readers, const Comm& comm);

} // namespace ndframe
