#include "ndframe/flow/flow_potentials.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;

/// L L^T in place in the lower triangle, row by row; the diagonal holds inverses. Columns of `values` become solutions:
/// a wrench a row.
void solveLaplacian(std::vector<double>& L, std::size_t size, double* values)
{
  for (std::size_t i = 0; i < size; ++i) {
    double* row = L.data() + i * size;
    for (std::size_t j = 0; j <= i; ++j) {
      const double* other = L.data() + j * size;
      double sum = row[j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= row[k] * other[k];
      if (j == i && !(sum > 0.0))
        throw NotPositiveDefinite(int(i));
      row[j] = j == i ? 1.0 / std::sqrt(sum) : sum * other[j];
    }
  }
  const auto add = [&](std::size_t to, double factor, std::size_t from) {
    for (std::size_t c = 0; c < wrench; ++c)
      values[to * wrench + c] += factor * values[from * wrench + c];
  };
  const auto scale = [&](std::size_t row) {
    for (std::size_t c = 0; c < wrench; ++c)
      values[row * wrench + c] *= L[row * size + row];
  };
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      add(i, -L[i * size + k], k);
    scale(i);
  }
  for (std::size_t i = size; i-- > 0;) {
    scale(i);
    for (std::size_t k = 0; k < i; ++k)
      add(k, -L[i * size + k], i);
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
