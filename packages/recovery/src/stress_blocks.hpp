#pragma once

#include "cell_blocks.hpp"
#include "stress_edges.hpp"
#include "stress_matrices.hpp"

namespace ndframe
{

/// The diagonal blocks of the energy as a function of the tractions that may change: one a face (StressFace::own), one
/// an edge (StressEdge::basis); unknowns are numbered in this order. Their inverses precondition the steps of
/// StressDescent.
class StressBlocks
{
public:
  /// Both must outlive it.
  StressBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges);

  int size() const { return begin_.back(); }
  /// The first unknown of a face or of an edge.
  int ofFace(int face) const { return begin_[std::size_t(face)]; }
  int ofEdge(std::size_t edge) const { return begin_[std::size_t(faces_->size()) + edge]; }

  /// What cells' matrices add to the blocks of their faces and edges, per cell. `first`: the number of the first cell;
  /// `work`: of the calling thread.
  std::vector<Vector> parts(int first, const CellMatrices& matrices, CellBlocks& work) const;
  void add(int cell, const Vector& parts);
  /// To be called when the ranks have added what is theirs. Collective.
  void invert(const Comm& comm, int threads);
  /// held: per block (faces, then edges), nonzero where the unknowns are not to change.
  Vector precondition(const Vector& gradient, const std::vector<char>& held, int threads) const;
  int numBlocks() const { return int(begin_.size()) - 1; }

private:
  int sizeOf(int block) const { return begin_[std::size_t(block) + 1] - begin_[std::size_t(block)]; }
  template <class Take>
  void eachBlock(int cell, const Take& take) const;
  void addEdge(int edge, int cell, const DenseMatrix& W, double* sum) const;

  const StressFaces* faces_;
  const std::vector<StressEdge>* edges_;
  std::vector<int> begin_{0};
  std::vector<std::vector<int>> edgesOf_; ///< per cell
  std::vector<std::size_t> at_{0};        ///< per block, in what follows: column by column
  Vector blocks_;                         ///< then their inverses
};

} // namespace ndframe
