#include "cell_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/simd/block_kernels.hpp"

namespace ndframe
{
namespace
{

/// The number of two facets among the pairs 01, 02, 03, 12, 13, 23.
std::ptrdiff_t pairOf(std::ptrdiff_t first, std::ptrdiff_t second)
{
  return first == 0 ? second - 1 : first + second;
}

/// The same with 00, 01, 02, 03, 11, .., 33.
std::ptrdiff_t placeOf(std::ptrdiff_t first, std::ptrdiff_t second)
{
  return first * 4 - first * (first - 1) / 2 + second - first;
}

} // namespace

CellBlocks::CellBlocks(const StressFaces& faces) : faces_(&faces), facetData_(faces.cells().facetData())
{
  const auto make = [](std::size_t count, std::size_t size, Vector& values) {
    values.assign(count * size * size * std::size_t(lanes), 0.0);
  };
  make(4, mostRows, alone_);
  make(6, linear, pairs_);
  make(4, mostOwn, own_);
  make(10, wrench, carriers_);
  make(6, wrench, edges_);
}

void CellBlocks::compute(const CellFacets& matrices)
{
  std::copy_n(matrices.cells, matrices.count, cells_.begin());
  double inverse[9 * lanes];
  for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
    for (std::ptrdiff_t k = 0; k < 9; ++k)
      inverse[k * lanes + lane] = matrices.maps[lane].inverse[std::size_t(k)];
  findShapes(matrices);
  const double *alone = matrices.facets.alone, *pair = matrices.facets.pairs;
  for (std::ptrdiff_t f = 0; f < 4; ++f) {
    double* A = alone_.data() + f * mostRows * mostRows * lanes;
    const Shapes& shape = shapes_[std::size_t(f)];
    block_kernels::turnSymmetric(alone, inverse, facetData_, A);
    alone += std::ptrdiff_t(facetData_) * (facetData_ + 1) / 2 * lanes;
    block_kernels::findOwn(A, shape.arms, facetData_, own_.data() + f * mostOwn * mostOwn * lanes);
    block_kernels::multiplyCarriers(A, mostRows, shape.carrier, shape.carrier,
                                    carriers_.data() + placeOf(f, f) * wrench * wrench * lanes);
  }
  for (std::ptrdiff_t f = 0; f < 4; ++f)
    for (std::ptrdiff_t g = f + 1; g < 4; ++g, pair += linear * linear * lanes) {
      double* A = pairs_.data() + pairOf(f, g) * linear * linear * lanes;
      block_kernels::turn(pair, inverse, A);
      block_kernels::multiplyCarriers(A, linear, shapes_[std::size_t(g)].carrier, shapes_[std::size_t(f)].carrier,
                                      carriers_.data() + placeOf(f, g) * wrench * wrench * lanes);
    }
  for (std::ptrdiff_t f = 0; f < 4; ++f)
    for (std::ptrdiff_t g = f + 1; g < 4; ++g)
      findEdge(f, g);
}

void CellBlocks::findShapes(const CellFacets& matrices)
{
  for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
    const int cell = matrices.cells[std::min(int(lane), matrices.count - 1)];
    const SortedCell sorted = faces_->cells().sorted(cell);
    double* to = points_ + lane;
    for (const int vertex : sorted.vertices)
      for (int i = 0; i < 3; ++i, to += lanes)
        *to = faces_->cells().mesh(cell).point(vertex)[i];
    for (int facet = 0; facet < 4; ++facet)
      putShape(lane, std::size_t(facet), (*faces_)[faces_->within(cell, facet)]);
  }
  for (Shapes& shape : shapes_)
    block_kernels::findCarrier(shape.arms, shape.size, shape.carrier);
}

void CellBlocks::putShape(std::ptrdiff_t lane, std::size_t facet, const StressFace& face)
{
  Shapes& shape = shapes_[facet];
  shape.size[lane] = face.size;
  for (std::size_t i = 0; i < 3; ++i) {
    shape.centre[std::ptrdiff_t(i) * lanes + lane] = face.centre[i];
    shape.arms[std::ptrdiff_t(i) * lanes + lane] = face.arms[0][i];
    shape.arms[std::ptrdiff_t(i + 3) * lanes + lane] = face.arms[1][i];
  }
}

/// The edge that two facets share: between the two other vertices.
void CellBlocks::findEdge(std::ptrdiff_t first, std::ptrdiff_t second)
{
  std::array<std::ptrdiff_t, 2> ends{};
  for (std::ptrdiff_t v = 0, n = 0; v < 4; ++v)
    if (v != first && v != second)
      ends[std::size_t(n++)] = v;
  const Shapes *f = &shapes_[std::size_t(first)], *g = &shapes_[std::size_t(second)];
  double arms[2][3 * lanes], length[2][lanes];
  for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
    double squares = 0.0;
    for (std::ptrdiff_t i = 0; i < 3; ++i) {
      const double a = points_[(3 * ends[0] + i) * lanes + lane], b = points_[(3 * ends[1] + i) * lanes + lane];
      squares += (a - b) * (a - b);
      arms[0][i * lanes + lane] = (0.5 * (a + b) - f->centre[i * lanes + lane]) / f->size[lane];
      arms[1][i * lanes + lane] = (0.5 * (a + b) - g->centre[i * lanes + lane]) / g->size[lane];
    }
    length[0][lane] = std::sqrt(squares) / f->size[lane];
    length[1][lane] = std::sqrt(squares) / g->size[lane];
  }
  const auto part = [this](std::ptrdiff_t a, std::ptrdiff_t b) {
    return carriers_.data() + placeOf(a, b) * wrench * wrench * lanes;
  };
  double* result = edges_.data() + pairOf(first, second) * wrench * wrench * lanes;
  block_kernels::findEdge({part(first, first), part(second, second), part(first, second)}, {arms[0], arms[1]},
                          {length[0], length[1]}, result);
}

void CellBlocks::addFace(int lane, int facet, double* sum) const
{
  const int cell = cells_[std::size_t(lane)];
  const StressFace& face = (*faces_)[faces_->of(cell, facet)];
  if (face.isInside()) {
    const double* entry = own_.data() + facet * mostOwn * mostOwn * lanes + lane;
    for (int k = 0; k < face.numOwn(); ++k)
      for (int l = k; l < face.numOwn(); ++l)
        *sum++ += entry[(k * mostOwn + l) * lanes];
    return;
  }
  const DenseMatrix X = face.onSide(face.sideOf(cell), face.allOwn());
  for (int k = 0; k < X.cols(); ++k)
    for (int l = k; l < X.cols(); ++l, ++sum)
      for (int j = 0; j < X.rows(); ++j)
        for (int i = 0; i < X.rows(); ++i)
          *sum += X(i, l) * alone(lane, facet, i, j) * X(j, k);
}

/// A of linear tractions between two facets.
double CellBlocks::between(int lane, std::array<int, 2> facets, std::ptrdiff_t i, std::ptrdiff_t j) const
{
  if (facets[0] == facets[1])
    return alone(lane, facets[0], i, j);
  if (facets[0] < facets[1]) {
    std::swap(facets[0], facets[1]);
    std::swap(i, j);
  }
  const std::ptrdiff_t pair = pairOf(facets[1], facets[0]);
  return *(pairs_.data() + ((pair * linear + j) * linear + i) * lanes + lane);
}

void CellBlocks::addEdge(int lane, const StressEdge& edge, Pair inside, double* sum) const
{
  if (inside[0] >= 0) {
    const double* entry = edges_.data() + pairOf(inside[0], inside[1]) * wrench * wrench * lanes + lane;
    for (std::ptrdiff_t k = 0; k < wrench; ++k)
      for (std::ptrdiff_t l = k; l < wrench; ++l)
        *sum++ += entry[(k * wrench + l) * lanes];
    return;
  }
  const auto columns = edgeColumns(edge, *faces_, cells_[std::size_t(lane)]);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      const DenseMatrix &left = columns[std::size_t(a)], &right = columns[std::size_t(b)];
      double* column = sum;
      for (int k = 0; k < right.cols() && left.cols() > 0; column += right.cols() - k, ++k)
        for (int j = 0; j < linear; ++j)
          for (int i = 0; i < linear; ++i) {
            const double value = between(lane, {a, b}, i, j) * right(j, k);
            for (int l = k; l < left.cols(); ++l)
              column[l - k] += left(i, l) * value;
          }
    }
}

} // namespace ndframe
