#pragma once

#include "cell_blocks.hpp"
#include "class_blocks.hpp"
#include "stress_sharing.hpp"

namespace ndframe
{

/// The diagonal blocks of the energy as a function of the tractions that may change: one a face (StressFace::own), one
/// an edge (StressEdge::unknowns); unknowns are numbered in this order. Their inverses precondition the steps of
/// StressDescent. Blocks that are the same but for a factor (ClassBlocks) are kept once. Faces without an own cell have
/// none.
class StressBlocks
{
public:
  /// All must outlive it.
  StressBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges, const ClassMatrices& matrices);

  int size() const { return begin_.back(); }
  /// The first unknown of a face or of an edge.
  int ofFace(int face) const { return begin_[std::size_t(face)]; }
  int ofEdge(std::size_t edge) const { return begin_[std::size_t(faces_->size()) + edge]; }

  /// What a lane's cell adds to the blocks that its faces and edges have alone.
  Vector parts(const CellBlocks& found, int lane, int cell) const;
  /// The same for a cell with the matrix of its class.
  Vector partsOfClass(int cell) const;
  void add(int cell, const Vector& parts);
  /// To be called when every rank has added its own cells: blocks that a rank owns are then complete. Collective.
  void invert(const StressSharing& sharing, int threads);
  /// The largest that an inverse times a gradient of the order of one can be, in order; the same on all ranks.
  double unit() const { return unit_; }
  /// Inverses over unit(). held: per block (faces, then edges), nonzero where the unknowns are not to change.
  void precondition(const std::vector<float>& gradient, const std::vector<char>& held, int threads,
                    std::vector<float>& result) const;
  /// A block's unknowns.
  SharedValues::Place placeOf(int block) const
  {
    return {std::size_t(begin_[std::size_t(block)]), std::size_t(sizeOf(block))};
  }
  int numBlocks() const { return int(begin_.size()) - 1; }
  /// Blocks that differ.
  int numKept() const { return numKept_; }

private:
  int sizeOf(int block) const { return begin_[std::size_t(block) + 1] - begin_[std::size_t(block)]; }
  /// Of a triangle in double precision; the square of the inverse in single precision takes no more.
  std::size_t entries(int block) const
  {
    const auto size = std::size_t(sizeOf(block));
    return size * (size + 1) / 2;
  }
  bool isShared(int block) const { return isShared_[std::size_t(block)] != 0; }
  void place();
  void listEdges();
  template <class Take>
  void eachBlock(int cell, const Take& take) const;
  template <class AddFace, class AddEdge>
  Vector parts(int cell, const AddFace& addFace, const AddEdge& addEdge) const;
  CellBlocks::Pair insideAt(const StressEdge& edge, std::size_t step) const;
  void invertAlike(const int* first, const int* last, Vector& scales);
  Vector square(int block) const;
  double keep(int block, const double* inverse, const double* diagonal);

  const StressFaces* faces_;
  const std::vector<StressEdge>* edges_;
  ClassBlocks ofClasses_;
  int numKept_ = 0;
  std::vector<int> begin_{0};
  /// An edge of a cell.
  struct Place
  {
    int edge;
    CellBlocks::Pair facets; ///< insideAt()
  };
  static constexpr int mostUnknowns = 18; ///< of a block
  std::vector<Place> edgesOf_;            ///< edges with blocks of their own, cell by cell
  std::vector<int> firstEdge_;
  std::vector<int> first_;     ///< per block the first that shares its matrix
  std::vector<char> isShared_; ///< per block: equal to those with the same key
  double unit_ = 0.0;
  Vector factor_;               ///< per block, of the shared inverse
  std::vector<std::size_t> at_; ///< per block, in blocks_
  std::size_t alone_ = 0;       ///< entries of blocks that are not shared; they come first
  Vector blocks_;               ///< lower triangles; then the inverses, see keep()
  std::vector<char> isExact_;   ///< per block: the inverse is a triangle in double precision
};

} // namespace ndframe
