#include "stress_blocks.hpp"

#include <algorithm>
#include <array>

#include "ndframe/algebra/threads.hpp"

namespace ndframe
{
namespace
{

/// sum += left^T W right, column by column; the part of W where the faces' carriers are.
void addProduct(const ThroughMatrix& left, const DenseMatrix& W, int row, int col, const ThroughMatrix& right,
                double* sum)
{
  for (int j = 0; j < right.cols; ++j, sum += left.cols) {
    double w[6] = {};
    for (int k = 0; k < right.rows; ++k)
      for (int i = 0; i < left.rows; ++i)
        w[i] += W(row + i, col + k) * right(k, j);
    for (int l = 0; l < left.cols; ++l)
      for (int i = 0; i < left.rows; ++i)
        sum[l] += left(i, l) * w[i];
  }
}

} // namespace

StressBlocks::StressBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges)
    : faces_(&faces), edges_(&edges), edgesOf_(std::size_t(faces.cells().size()))
{
  const auto addBlock = [&](int size) {
    at_.push_back(at_.back() + std::size_t(size) * std::size_t(size));
    begin_.push_back(begin_.back() + size);
  };
  for (const StressFace& face : faces.all())
    addBlock(face.numOwn());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    addBlock(edges[e].basis.cols());
    for (const StressEdge::Step& step : edges[e].ring)
      if (step.cell >= 0)
        edgesOf_[std::size_t(step.cell)].push_back(int(e));
  }
  blocks_.assign(at_.back(), 0.0);
}

/// take(block) for those of a cell's faces, then of its edges.
template <class Take>
void StressBlocks::eachBlock(int cell, const Take& take) const
{
  for (int facet = 0; facet < 4; ++facet)
    take(faces_->of(cell, facet));
  for (const int e : edgesOf_[std::size_t(cell)])
    take(faces_->size() + e);
}

std::vector<Vector> StressBlocks::parts(int first, const CellMatrices& matrices, CellBlocks& blocks) const
{
  blocks.clear();
  for (int lane = 0; lane < matrices.count; ++lane)
    for (int facet = 0; facet < 4; ++facet) {
      const StressFace& face = (*faces_)[faces_->of(first + lane, facet)];
      blocks.put(lane, facet, face, face.sideOf(first + lane));
    }
  blocks.compute(matrices);
  std::vector<Vector> result(std::size_t(matrices.count));
  for (int lane = 0; lane < matrices.count; ++lane) {
    Vector& parts = result[std::size_t(lane)];
    const int cell = first + lane;
    std::size_t entries = 0;
    eachBlock(cell, [&](int block) { entries += std::size_t(sizeOf(block)) * std::size_t(sizeOf(block)); });
    parts.reserve(entries);
    for (int facet = 0; facet < 4; ++facet)
      blocks.addOwn(lane, facet, sizeOf(faces_->of(cell, facet)), parts);
    const DenseMatrix W = blocks.ofCarriers(lane);
    for (const int e : edgesOf_[std::size_t(cell)]) {
      const std::size_t begin = parts.size(), size = std::size_t(sizeOf(faces_->size() + e));
      parts.resize(begin + size * size, 0.0);
      addEdge(e, cell, W, parts.data() + begin);
    }
  }
  return result;
}

void StressBlocks::add(int cell, const Vector& parts)
{
  const double* part = parts.data();
  eachBlock(cell, [&](int block) {
    for (std::size_t entry = at_[std::size_t(block)]; entry < at_[std::size_t(block) + 1]; ++entry)
      blocks_[entry] += *part++;
  });
}

/// The part of an edge's block by what the carriers of a cell's faces do to each other, W.
void StressBlocks::addEdge(int e, int cell, const DenseMatrix& W, double* sum) const
{
  const StressEdge& edge = (*edges_)[std::size_t(e)];
  std::array<ThroughMatrix, 4> through; // and where the face's carriers begin
  std::array<int, 4> begin{};
  std::size_t count = 0;
  for (const StressEdge::Step& step : edge.ring)
    for (int facet = 0; facet < 4; ++facet)
      if (faces_->of(cell, facet) == step.face) {
        through[count] = ThroughMatrix(edge, step, (*faces_)[step.face]);
        begin[count++] = facet * CellBlocks::mostCarriers;
      }
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b)
      addProduct(through[a], W, begin[a], begin[b], through[b], sum);
}

void StressBlocks::invert(const Comm& comm, int threads)
{
  comm.sum(blocks_);
  runInRanges(numBlocks(), threads, [&](int first, int last) {
    for (int b = first; b < last; ++b) {
      DenseMatrix block(sizeOf(b), sizeOf(b));
      double* values = blocks_.data() + at_[std::size_t(b)];
      const std::size_t entries = at_[std::size_t(b) + 1] - at_[std::size_t(b)];
      std::copy_n(values, entries, block.col(0));
      const DenseMatrix inverse = DenseCholesky(std::move(block)).inverse();
      std::copy_n(inverse.col(0), entries, values);
    }
  });
}

Vector StressBlocks::precondition(const Vector& gradient, const std::vector<char>& held, int threads) const
{
  Vector result(gradient.size(), 0.0);
  runInRanges(numBlocks(), threads, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) {
      const auto first = std::size_t(begin_[std::size_t(b)]),
                 size = std::size_t(held[std::size_t(b)] != 0 ? 0 : sizeOf(b));
      const double* column = blocks_.data() + at_[std::size_t(b)];
      for (std::size_t j = 0; j < size; ++j, column += size)
        for (std::size_t i = 0; i < size; ++i)
          result[first + i] += column[i] * gradient[first + j];
    }
  });
  return result;
}

} // namespace ndframe
