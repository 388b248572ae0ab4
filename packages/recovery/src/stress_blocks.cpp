#include "stress_blocks.hpp"

#include <algorithm>

#include "stress_matrices.hpp"

namespace ndframe
{
namespace
{

/// A diagonal block of a square matrix.
DenseMatrix partOf(const DenseMatrix& A, int first, int size)
{
  DenseMatrix part(size, size);
  for (int j = 0; j < size; ++j)
    std::copy_n(A.col(first + j) + first, size, part.col(j));
  return part;
}

void addTo(DenseMatrix& sum, const DenseMatrix& other)
{
  for (int j = 0; j < sum.cols(); ++j)
    for (int i = 0; i < sum.rows(); ++i)
      sum(i, j) += other(i, j);
}

/// sum += left^T W(row.., col..) right
void addProduct(const DenseMatrix& left, const DenseMatrix& W, int row, int col, const DenseMatrix& right,
                DenseMatrix& sum)
{
  for (int j = 0; j < right.cols(); ++j) {
    double w[6] = {};
    for (int k = 0; k < right.rows(); ++k)
      for (int i = 0; i < left.rows(); ++i)
        w[i] += W(row + i, col + k) * right(k, j);
    for (int l = 0; l < left.cols(); ++l)
      for (int i = 0; i < left.rows(); ++i)
        sum(l, j) += left(i, l) * w[i];
  }
}

} // namespace

StressBlocks::StressBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges)
    : faces_(&faces), edges_(&edges), edgesOf_(std::size_t(faces.cells().size()))
{
  const auto addBlock = [&](int size) {
    blocks_.emplace_back(size, size);
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
}

void StressBlocks::add(int cell, const CellMap& map, const DenseMatrix& A)
{
  const int size = faces_->cells().facetData();
  std::array<int, 4> faces{}, begin{};
  int columns = 0;
  for (int facet = 0; facet < 4; ++facet) {
    const auto at = std::size_t(facet);
    faces[at] = faces_->of(cell, facet);
    const StressFace& face = (*faces_)[faces[at]];
    begin[at] = columns;
    columns += face.carrier.cols();
    const DenseMatrix own = pulledBack(map, face.onSide(face.sideOf(cell), face.allOwn()));
    if (own.cols() > 0)
      addTo(blocks_[std::size_t(faces[at])], multiplyTransposed(own, multiply(partOf(A, facet * size, size), own)));
  }
  DenseMatrix carriers(4 * size, columns); // on this cell
  for (int facet = 0; facet < 4; ++facet) {
    const StressFace& face = (*faces_)[faces[std::size_t(facet)]];
    const DenseMatrix carrier = pulledBack(map, face.onSide(face.sideOf(cell), face.carrier));
    for (int j = 0; j < carrier.cols(); ++j)
      std::copy_n(carrier.col(j), carrier.rows(),
                  carriers.col(begin[std::size_t(facet)] + j) + std::ptrdiff_t(facet) * size);
  }
  const DenseMatrix W = multiplyTransposed(carriers, multiply(partOf(A, 0, carriers.rows()), carriers));
  for (const int e : edgesOf_[std::size_t(cell)])
    addEdge(e, faces, begin, W);
}

/// The part of an edge's block by what the carriers of a cell's faces do to each other, W.
void StressBlocks::addEdge(int e, const std::array<int, 4>& faces, const std::array<int, 4>& begin,
                           const DenseMatrix& W)
{
  const StressEdge& edge = (*edges_)[std::size_t(e)];
  std::vector<std::pair<DenseMatrix, int>> through; // and where the face's carriers begin
  for (const StressEdge::Step& step : edge.ring)
    if (const auto at = std::find(faces.begin(), faces.end(), step.face); at != faces.end())
      through.emplace_back(throughMatrix(edge, step, (*faces_)[step.face]), begin[std::size_t(at - faces.begin())]);
  for (const auto& [a, row] : through)
    for (const auto& [b, col] : through)
      addProduct(a, W, row, col, b, blocks_[std::size_t(faces_->size() + e)]);
}

void StressBlocks::invert()
{
  for (DenseMatrix& block : blocks_) {
    const int size = block.rows();
    if (size == 0)
      continue;
    const DenseCholesky factor(std::move(block));
    block = DenseMatrix(size, size);
    for (int j = 0; j < size; ++j) {
      Vector unit(std::size_t(size), 0.0);
      unit[std::size_t(j)] = 1.0;
      const Vector column = factor.solve(std::move(unit));
      std::copy(column.begin(), column.end(), block.col(j));
    }
  }
}

Vector StressBlocks::precondition(const Vector& gradient, const std::vector<char>& held) const
{
  Vector result(gradient.size(), 0.0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const int first = begin_[b], size = held[b] != 0 ? 0 : blocks_[b].rows();
    for (int j = 0; j < size; ++j) {
      const double* column = blocks_[b].col(j);
      for (int i = 0; i < size; ++i)
        result[std::size_t(first + i)] += column[i] * gradient[std::size_t(first + j)];
    }
  }
  return result;
}

} // namespace ndframe
