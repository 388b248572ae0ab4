#include "class_blocks.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t mostData = 18; ///< of a face

/// A matrix by columns of at most so many entries, and of as many columns at most.
struct FaceColumns
{
  const double* columns;
  std::size_t rows, cols;

  explicit FaceColumns(const DenseMatrix& matrix)
      : columns(matrix.col(0)), rows(std::size_t(matrix.rows())), cols(std::size_t(matrix.cols()))
  {
    NDFRAME_ASSERT(rows <= mostData && cols <= mostData, "more data than a face has");
  }
};

/// sum += factor left^T A right; A's columns are `stride` apart.
NDFRAME_EVERY_PROCESSOR void addCongruent(const double* A, std::size_t stride, const FaceColumns& left,
                                          const FaceColumns& right, double factor, double* sum)
{
  const double* x = right.columns;
  for (std::size_t j = 0; j < right.cols; ++j, x += right.rows) {
    double product[mostData] = {};
    for (std::size_t k = 0; k < right.rows; ++k)
      for (std::size_t i = 0; i < left.rows; ++i)
        product[i] += A[k * stride + i] * (factor * x[k]);
    double sums[mostData] = {}; // side by side: each on its own waits for one addition after the other
    for (std::size_t i = 0; i < left.rows; ++i)
      for (std::size_t l = 0; l < left.cols; ++l)
        sums[l] += left.columns[l * left.rows + i] * product[i];
    for (std::size_t l = 0; l < left.cols; ++l)
      *sum++ += sums[l];
  }
}

} // namespace

std::vector<int> ClassBlocks::keyOfFace(int f) const
{
  const StressFace& face = (*faces_)[f];
  if (!face.isInside() || !matrices_->has(face.cell[0]) || !matrices_->has(face.cell[1]))
    return {};
  const CellClasses& classes = faces_->cells().classes();
  return {classes.of(face.cell[0]), classes.of(face.cell[1]), face.facet[0] * 4 + face.facet[1]};
}

/// The class of the cell that a step of a ring leaves and the two facets that meet at the edge.
int ClassBlocks::codeAround(const StressEdge& edge, std::size_t step) const
{
  const auto& ring = edge.ring;
  const int cell = ring[step].cell;
  int facets = 0;
  for (const std::size_t s : {step, (step + ring.size() - 1) % ring.size()}) {
    const StressFace& face = (*faces_)[ring[s].face];
    facets |= 1 << face.facet[face.sideOf(cell)];
  }
  return faces_->cells().classes().of(cell) * 16 + facets;
}

std::vector<int> ClassBlocks::keyOfEdge(int e) const
{
  const StressEdge& edge = (*edges_)[std::size_t(e)];
  std::vector<int> key;
  for (const StressEdge::Step& step : edge.ring)
    if (step.cell < 0 || !matrices_->has(step.cell) || !(*faces_)[step.face].isInside())
      return {};
  key.reserve(edge.ring.size() + 1); // a mark comes behind
  for (std::size_t step = 0; step < edge.ring.size(); ++step)
    key.push_back(codeAround(edge, step));
  std::sort(key.begin(), key.end());
  return key;
}

double ClassBlocks::scaleOfEdge(int e) const
{
  const StressEdge& edge = (*edges_)[std::size_t(e)];
  int least = -1, code = 0;
  for (std::size_t step = 0; step < edge.ring.size(); ++step)
    if (const int own = codeAround(edge, step); least < 0 || own < code) {
      least = edge.ring[step].cell;
      code = own;
    }
  return scale(least);
}

/// sum += left^T A right, the part of A between two facets. A is symmetric: its columns are read as rows of the other
/// facet.
void ClassBlocks::addProduct(int cell, std::array<int, 2> facets, const DenseMatrix& left, const DenseMatrix& right,
                             double* sum) const
{
  const auto data = std::ptrdiff_t(faces_->cells().facetData()), stride = std::ptrdiff_t(matrices_->columns());
  const double* A = matrices_->of(cell) + data * facets[1] * stride + data * facets[0];
  addCongruent(A, std::size_t(stride), FaceColumns(left), FaceColumns(right), scale(cell), sum);
}

void ClassBlocks::addFace(int cell, int facet, double* sum) const
{
  const StressFace& face = (*faces_)[faces_->of(cell, facet)];
  const DenseMatrix columns = face.onSide(face.sideOf(cell), face.allOwn());
  addProduct(cell, {facet, facet}, columns, columns, sum);
}

void ClassBlocks::addEdge(int cell, int e, double* sum) const
{
  const auto columns = edgeColumns((*edges_)[std::size_t(e)], *faces_, cell);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      if (const auto& left = columns[std::size_t(a)], &right = columns[std::size_t(b)];
          left.cols() > 0 && right.cols() > 0)
        addProduct(cell, {a, b}, left, right, sum);
}

void ClassBlocks::addAllOfFace(int f, double* sum) const
{
  const StressFace& face = (*faces_)[f];
  for (std::size_t side = 0; side < 2; ++side)
    addFace(face.cell[side], face.facet[side], sum);
}

void ClassBlocks::addAllOfEdge(int e, double* sum) const
{
  for (const StressEdge::Step& step : (*edges_)[std::size_t(e)].ring)
    addEdge(step.cell, e, sum);
}

} // namespace ndframe
