#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/index_map.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

/// Symmetric sparse matrix of dim x dim blocks, one block row per mesh node; dof = node * dim + component.
///
/// A rank holds the complete rows of the nodes that it owns; the columns are numbered as this rank numbers nodes.
struct BlockMatrix
{
  int dim = 0;                      ///< rows and columns of a block
  IndexMap nodes;                   ///< one row for each owned node; the columns are owned nodes and ghosts
  std::vector<std::int64_t> rowPtr; ///< size numRows() + 1, counts blocks
  std::vector<int> cols;            ///< this rank's numbers of nodes, ascending in a row
  std::vector<double> values;       ///< dim*dim per block, row-major inside a block

  int numRows() const { return nodes.numOwned(); } ///< block rows of this rank
  /// Of all ranks. Asserts that vectors of all of them are numbered by 32 bits.
  int numNodes() const
  {
    NDFRAME_ASSERT(nodes.globalSize() <= std::numeric_limits<int>::max() / dim,
                   "too many nodes for replicated vectors");
    return int(nodes.globalSize());
  }
  int numDofs() const { return numNodes() * dim; }                     ///< of all ranks
  std::int64_t numBlocks() const { return std::int64_t(cols.size()); } ///< stored on this rank
  int rowNode(int r) const { return int(nodes.global(r)); }            ///< the node of a block row, of all ranks' nodes
  int colNode(std::int64_t b) const { return int(nodes.global(cols[std::size_t(b)])); } ///< that of a block's column
  /// The block row of a node of all ranks' nodes, -1 when it is another rank's.
  int rowOf(IndexMap::Global node) const;
  /// The block (block row, column as in `cols`); null if not in the pattern.
  const double* block(int r, int column) const;
  double* block(int r, int column); ///< the same, to be written
  void makeValues();                ///< zeros where the pattern has no values yet, in large pages
};

/// The rows of `owned` nodes, ascending, whose columns are numbers of all ranks' nodes, ascending in a row: numbers
/// them as this rank does, and sorts each row anew. values: empty: zeros.
BlockMatrix withOwnColumns(int dim, IndexMap::Global numNodes, const std::vector<int>& owned,
                           std::vector<std::int64_t> rowPtr, std::vector<int> cols, std::vector<double> values);

/// The rows of the nodes that this rank owns of `nodes`, whose columns are its numbers of them, ascending in a row.
/// Ghosts that are no column are left out.
BlockMatrix withoutIdleGhosts(int dim, const IndexMap& nodes, std::vector<std::int64_t> rowPtr, std::vector<int> cols,
                              std::vector<double> values);

/// y += K x by this rank's rows. placeOf: of a node that the matrix holds, by the matrix's number, in x and y.
template <class PlaceOf>
void addProduct(const BlockMatrix& K, const Vector& x, Vector& y, const PlaceOf& placeOf)
{
  const auto dim = std::size_t(K.dim);
  const double* entry = K.values.data();
  for (int r = 0; r < K.numRows(); ++r) {
    double* const yRow = y.data() + std::size_t(placeOf(r)) * dim;
    for (auto b = std::size_t(K.rowPtr[std::size_t(r)]); b < std::size_t(K.rowPtr[std::size_t(r) + 1]); ++b) {
      const double* const xCol = x.data() + std::size_t(placeOf(K.cols[b])) * dim;
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j)
          yRow[i] += *entry++ * xCol[j];
    }
  }
}

/// y = K x with x and y replicated on all ranks.
Vector multiply(const BlockMatrix& K, const Vector& x, const Comm& comm);

/// The diagonal, replicated on all ranks.
Vector diagonal(const BlockMatrix& K, const Comm& comm);

/// What computing a row of a product may leave, relative to the product of the moduli: unit round-offs, and something
/// for the length of the rows.
inline constexpr double rowRoundOff = 16.0 * std::numeric_limits<double>::epsilon();

} // namespace ndframe
