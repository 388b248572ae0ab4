#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// Symmetric sparse matrix of dim x dim blocks, one block row per mesh node; dof = node * dim + component.
///
/// A rank holds the complete rows of the nodes it owns (`rows`, ascending; all nodes on one rank); column numbers are
/// global.
struct BlockMatrix
{
  int dim = 0;                      ///< rows and columns of a block
  int numNodes = 0;                 ///< of all ranks
  std::vector<int> rows;            ///< owned nodes, ascending
  std::vector<std::int64_t> rowPtr; ///< size rows.size() + 1, counts blocks
  std::vector<int> cols;            ///< node numbers, ascending in a row
  std::vector<double> values;       ///< dim*dim per block, row-major inside a block

  int numDofs() const { return numNodes * dim; }                       ///< of all ranks
  std::int64_t numBlocks() const { return std::int64_t(cols.size()); } ///< stored on this rank
  /// The block (row index r into `rows`, column node); null if not in the pattern.
  const double* block(int r, int colNode) const;
  double* block(int r, int colNode); ///< the same, to be written
};

/// y = K x with x and y replicated on all ranks.
Vector multiply(const BlockMatrix& K, const Vector& x, const Comm& comm);

/// The diagonal, replicated on all ranks.
Vector diagonal(const BlockMatrix& K, const Comm& comm);
/// Mean of the diagonal over all rows, a scale for springs and tolerances.
double meanDiagonal(const BlockMatrix& K, const Comm& comm);

/// What computing K u may leave of a residual, whatever u is, as a Euclidean norm: unit round-offs times |K| |u|, and
/// something for the length of the rows.
double productRoundOff(const BlockMatrix& K, const Vector& u, const Comm& comm);

} // namespace ndframe
