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

StressBlocks::StressBlocks(const StarBody& body, const StressFaces& faces)
    : body_(&body), faces_(&faces), edgesOf_(std::size_t(body.model().mesh.numCells()))
{
  const auto addBlock = [&](int size) {
    blocks_.emplace_back(size, size);
    begin_.push_back(begin_.back() + size);
  };
  for (const StressFace& face : faces.faces())
    addBlock(face.own.cols());
  for (std::size_t e = 0; e < faces.edges().size(); ++e) {
    addBlock(faces.edges()[e].basis.cols());
    for (const StressEdge::Step& step : faces.edges()[e].ring)
      if (step.cell >= 0)
        edgesOf_[std::size_t(step.cell)].push_back(int(e));
  }
}

void StressBlocks::add(int cell, const DenseMatrix& A)
{
  const Mesh& mesh = body_->model().mesh;
  const CellMap map = cellMap(mesh, sortedCell(mesh, cell));
  const int size = body_->facetData();
  std::array<int, 4> faces{}, begin{};
  int columns = 0;
  for (int facet = 0; facet < 4; ++facet) {
    const auto at = std::size_t(facet);
    faces[at] = faces_->faceOf(cell, facet);
    const StressFace& face = faces_->faces()[std::size_t(faces[at])];
    begin[at] = columns;
    columns += face.carrier.cols();
    const DenseMatrix own = pulledBack(map, face.own);
    if (own.cols() > 0)
      addTo(blocks_[std::size_t(faces[at])], multiplyTransposed(own, multiply(partOf(A, facet * size, size), own)));
  }
  DenseMatrix carriers(body_->reference().tractions, columns); // on this cell
  for (int facet = 0; facet < 4; ++facet) {
    const StressFace& face = faces_->faces()[std::size_t(faces[std::size_t(facet)])];
    const double sign = face.cell[0] == cell ? 1.0 : -1.0;
    const DenseMatrix own = pulledBack(map, face.carrier);
    for (int j = 0; j < own.cols(); ++j)
      for (int i = 0; i < size; ++i)
        carriers(facet * size + i, begin[std::size_t(facet)] + j) = sign * own(i, j);
  }
  const DenseMatrix W = multiplyTransposed(carriers, multiply(partOf(A, 0, carriers.rows()), carriers));
  for (const int e : edgesOf_[std::size_t(cell)])
    for (const StressEdge::Step& a : faces_->edges()[std::size_t(e)].ring)
      for (const StressEdge::Step& b : faces_->edges()[std::size_t(e)].ring) {
        const auto first = std::find(faces.begin(), faces.end(), a.face),
                   second = std::find(faces.begin(), faces.end(), b.face);
        if (first != faces.end() && second != faces.end())
          addProduct(a.through, W, begin[std::size_t(first - faces.begin())],
                     begin[std::size_t(second - faces.begin())], b.through,
                     blocks_[faces_->faces().size() + std::size_t(e)]);
      }
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

Vector StressBlocks::precondition(const Vector& gradient) const
{
  Vector result(gradient.size(), 0.0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const int first = begin_[b], size = blocks_[b].rows();
    for (int j = 0; j < size; ++j) {
      const double* column = blocks_[b].col(j);
      for (int i = 0; i < size; ++i)
        result[std::size_t(first + i)] += column[i] * gradient[std::size_t(first + j)];
    }
  }
  return result;
}

} // namespace ndframe
