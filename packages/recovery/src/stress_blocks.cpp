#include "stress_blocks.hpp"

#include <algorithm>
#include <array>

#include "ndframe/algebra/threads.hpp"
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

/// sum += left^T A(row.., col..) right, column by column; columns of the sum are `rows` apart.
void addCongruence(const DenseMatrix& left, int row, const DenseMatrix& A, int col, const DenseMatrix& right,
                   double* sum, int rows)
{
  std::array<double, 18> product{}; // facet data at most
  for (int k = 0; k < right.cols(); ++k, sum += rows) {
    std::fill_n(product.begin(), left.rows(), 0.0);
    const auto [first, last] = support(right, k);
    for (int j = first; j < last; ++j) {
      const double *entries = A.col(col + j) + row, factor = right(j, k);
      for (int i = 0; i < left.rows(); ++i)
        product[std::size_t(i)] += entries[i] * factor;
    }
    for (int l = 0; l < left.cols(); ++l) {
      const auto [begin, end] = support(left, l);
      for (int i = begin; i < end; ++i)
        sum[l] += left(i, l) * product[std::size_t(i)];
    }
  }
}

/// sum += left^T W(row.., col..) right, column by column.
void addProduct(const DenseMatrix& left, const DenseMatrix& W, int row, int col, const DenseMatrix& right, double* sum)
{
  for (int j = 0; j < right.cols(); ++j, sum += left.cols()) {
    double w[6] = {};
    for (int k = 0; k < right.rows(); ++k)
      for (int i = 0; i < left.rows(); ++i)
        w[i] += W(row + i, col + k) * right(k, j);
    for (int l = 0; l < left.cols(); ++l)
      for (int i = 0; i < left.rows(); ++i)
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

Vector StressBlocks::parts(int cell, const CellMap& map, const DenseMatrix& A) const
{
  std::size_t entries = 0;
  eachBlock(cell, [&](int block) { entries += std::size_t(sizeOf(block)) * std::size_t(sizeOf(block)); });
  Vector result(entries, 0.0);
  double* part = result.data();
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
    addCongruence(own, int(facet) * size, A, int(facet) * size, own, part, own.cols());
    part += std::ptrdiff_t(own.cols()) * own.cols();
  }
  DenseMatrix W(columns, columns);
  for (std::size_t g = 0; g < 4; ++g)
    for (std::size_t f = 0; f <= g; ++f)
      addCongruence(carriers[f], int(f) * size, A, int(g) * size, carriers[g], W.col(begin[g]) + begin[f], columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < j; ++i)
      W(j, i) = W(i, j);
  for (const int e : edgesOf_[std::size_t(cell)]) {
    addEdge(e, faces, begin, W, part);
    part += std::ptrdiff_t(sizeOf(faces_->size() + e)) * sizeOf(faces_->size() + e);
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
void StressBlocks::addEdge(int e, const std::array<int, 4>& faces, const std::array<int, 4>& begin,
                           const DenseMatrix& W, double* sum) const
{
  const StressEdge& edge = (*edges_)[std::size_t(e)];
  std::vector<std::pair<DenseMatrix, int>> through; // and where the face's carriers begin
  for (const StressEdge::Step& step : edge.ring)
    if (const auto at = std::find(faces.begin(), faces.end(), step.face); at != faces.end())
      through.emplace_back(throughMatrix(edge, step, (*faces_)[step.face]), begin[std::size_t(at - faces.begin())]);
  for (const auto& [a, row] : through)
    for (const auto& [b, col] : through)
      addProduct(a, W, row, col, b, sum);
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
