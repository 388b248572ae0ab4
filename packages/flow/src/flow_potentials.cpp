#include "ndframe/flow/flow_potentials.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;

/// U^T D^-1 U in the upper triangle of a symmetric matrix, row by row, D the diagonal of U; columns of `values` become
/// solutions: a wrench a row. Most of a star's cells are no neighbours, so most of U is zero.
void solveLaplacian(std::vector<double>& U, std::size_t size, double* values)
{
  const auto add = [&](std::size_t to, double factor, std::size_t from) {
    for (std::size_t c = 0; c < wrench; ++c)
      values[to * wrench + c] += factor * values[from * wrench + c];
  };
  for (std::size_t k = 0; k < size; ++k) {
    const double* pivot = U.data() + k * size;
    if (!(pivot[k] > 0.0))
      throw NotPositiveDefinite(int(k));
    for (std::size_t i = k + 1; i < size; ++i) {
      if (pivot[i] == 0.0)
        continue;
      const double factor = -pivot[i] / pivot[k];
      double* row = U.data() + i * size;
      for (std::size_t j = i; j < size; ++j)
        row[j] += factor * pivot[j];
      add(i, factor, k);
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    const double* pivot = U.data() + k * size;
    for (std::size_t i = k + 1; i < size; ++i)
      if (pivot[i] != 0.0)
        add(k, -pivot[i], i);
    for (std::size_t c = 0; c < wrench; ++c)
      values[k * wrench + c] /= pivot[k];
  }
}

/// What flows out of the cells by their potentials, `components` a cell: one where the six do not depend on each other,
/// as without supports. The free motions are held at the last cell, where nothing is then left to take.
DenseMatrix conductances(int cells, const std::vector<FlowLink>& links, const DenseMatrix& free, int components)
{
  DenseMatrix L(cells * components, cells * components);
  const auto add = [&](int row, int col, int i, int j, double value) {
    L(row * components + i, col * components + j) += value;
  };
  const auto resist = [&](int cell, const DenseMatrix& columns, double factor) {
    addSquare(columns, factor, &L(cell * wrench, cell * wrench), L.rows());
  };
  double largest = 0.0;
  for (const FlowLink& link : links) {
    largest = std::max(largest, link.conductance);
    if (link.cell[1] < 0)
      resist(link.cell[0], link.through, link.conductance);
    for (int i = 0; i < components && link.cell[1] >= 0; ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        add(link.cell[side], link.cell[side], i, i, link.conductance);
        add(link.cell[side], link.cell[1 - side], i, i, -link.conductance);
      }
  }
  if (components == wrench)
    resist(cells - 1, free, largest);
  else
    add(cells - 1, cells - 1, 0, 0, cells == 1 ? 1.0 : largest);
  return L;
}

} // namespace

void addSquare(const DenseMatrix& columns, double factor, double* sum, int stride)
{
  for (int k = 0; k < columns.cols(); ++k)
    for (int j = 0; j < wrench; ++j)
      for (int i = 0; i < wrench; ++i)
        sum[std::ptrdiff_t(j) * stride + i] += factor * columns(i, k) * columns(j, k);
}

DenseMatrix freeMotions(const std::vector<FlowLink>& links)
{
  DenseMatrix ground(wrench, wrench);
  bool isHeld = false;
  for (const FlowLink& link : links)
    if (link.cell[1] < 0) {
      isHeld = true;
      addSquare(link.through, 1.0, ground.data(), wrench);
    }
  if (isHeld)
    return nullSpace(ground, rigidTolerance);
  DenseMatrix all(wrench, wrench);
  for (int i = 0; i < wrench; ++i)
    all(i, i) = 1.0;
  return all;
}

DenseMatrix potentials(const std::vector<FlowLink>& links, const DenseMatrix& free, DenseMatrix needed)
{
  const int cells = needed.cols();
  if (free.cols() == wrench) {
    const DenseMatrix L = conductances(cells, links, free, 1);
    std::vector<double> values(L.data(), L.data() + std::ptrdiff_t(cells) * cells);
    solveLaplacian(values, std::size_t(cells), needed.data());
    return needed;
  }
  Vector all(needed.data(), needed.data() + std::ptrdiff_t(cells) * wrench);
  all = DenseCholesky(conductances(cells, links, free, wrench)).solve(std::move(all));
  std::copy(all.begin(), all.end(), needed.data());
  return needed;
}

} // namespace ndframe
