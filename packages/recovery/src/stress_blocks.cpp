#include "stress_blocks.hpp"

#include <algorithm>
#include <array>

#include "stress_matrices.hpp"

namespace ndframe
{
namespace
{

/// The rows of a column that are not zero.
std::pair<int, int> support(const DenseMatrix& columns, int k)
{
  const double* column = columns.col(k);
  int first = 0, last = columns.rows();
  while (first < last && column[first] == 0.0)
    ++first;
  while (last > first && column[last - 1] == 0.0)
    --last;
  return {first, last};
}

/// sum(toRow.., toCol..) += left^T A(row.., col..) right
void addCongruence(const DenseMatrix& left, int row, const DenseMatrix& A, int col, const DenseMatrix& right,
                   DenseMatrix& sum, int toRow, int toCol)
{
  std::array<double, 18> product{}; // facet data at most
  const int rows = left.rows();
  for (int k = 0; k < right.cols(); ++k) {
    std::fill_n(product.begin(), rows, 0.0);
    const auto [first, last] = support(right, k);
    for (int j = first; j < last; ++j) {
      const double *entries = A.col(col + j) + row, factor = right(j, k);
      for (int i = 0; i < rows; ++i)
        product[std::size_t(i)] += entries[i] * factor;
    }
    for (int l = 0; l < left.cols(); ++l) {
      const auto [begin, end] = support(left, l);
      for (int i = begin; i < end; ++i)
        sum(toRow + l, toCol + k) += left(i, l) * product[std::size_t(i)];
    }
  }
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
  std::array<DenseMatrix, 4> carriers; // on this cell
  int columns = 0;
  for (std::size_t facet = 0; facet < 4; ++facet) {
    faces[facet] = faces_->of(cell, int(facet));
    const StressFace& face = (*faces_)[faces[facet]];
    begin[facet] = columns;
    columns += face.carrier.cols();
    carriers[facet] = pulledBack(map, face.onSide(face.sideOf(cell), face.carrier));
    const DenseMatrix own = pulledBack(map, face.onSide(face.sideOf(cell), face.allOwn()));
    addCongruence(own, int(facet) * size, A, int(facet) * size, own, blocks_[std::size_t(faces[facet])], 0, 0);
  }
  DenseMatrix W(columns, columns);
  for (std::size_t g = 0; g < 4; ++g)
    for (std::size_t f = 0; f <= g; ++f)
      addCongruence(carriers[f], int(f) * size, A, int(g) * size, carriers[g], W, begin[f], begin[g]);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < j; ++i)
      W(j, i) = W(i, j);
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
  for (DenseMatrix& block : blocks_)
    block = DenseCholesky(std::move(block)).inverse();
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
