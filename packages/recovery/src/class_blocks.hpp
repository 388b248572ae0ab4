#pragma once

#include "ndframe/simd/class_matrices.hpp"
#include "stress_edges.hpp"

namespace ndframe
{

/// What a cell with the matrix of its class adds to the blocks of its faces and edges (StressBlocks), and which blocks
/// are the same but for a factor.
class ClassBlocks
{
public:
  /// All must outlive it.
  ClassBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges, const ClassMatrices& matrices)
      : faces_(&faces), edges_(&edges), matrices_(&matrices)
  {}

  /// Equal where blocks are: the classes of the cells around, and where these have the face or edge. Empty where a cell
  /// has no class or the face or an edge's ring is not inside.
  std::vector<int> keyOfFace(int face) const;
  std::vector<int> keyOfEdge(int edge) const;
  /// Blocks with the same key are in proportion to this.
  double scaleOfFace(int face) const { return scale((*faces_)[face].cell[0]); }
  double scaleOfEdge(int edge) const;

  /// sum += own^T A own of the face at a cell's facet, column by column.
  void addFace(int cell, int facet, double* sum) const;
  /// sum += what the cell has of an edge's block, column by column.
  void addEdge(int cell, int edge, double* sum) const;
  /// The whole block of a face or edge with a key.
  void addAllOfFace(int face, double* sum) const;
  void addAllOfEdge(int edge, double* sum) const;

private:
  double scale(int cell) const { return faces_->cells().classes().scale(cell); }
  int codeAround(const StressEdge& edge, std::size_t step) const;
  void addProduct(int cell, std::array<int, 2> facets, const DenseMatrix& left, const DenseMatrix& right,
                  double* sum) const;

  const StressFaces* faces_;
  const std::vector<StressEdge>* edges_;
  const ClassMatrices* matrices_;
};

} // namespace ndframe
