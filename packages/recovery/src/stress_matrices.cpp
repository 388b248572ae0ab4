#include "stress_matrices.hpp"

#include <algorithm>

#include "ndframe/equilibrium/cell_forms.hpp"

namespace ndframe
{
namespace
{

constexpr int together = 64; ///< cells of one product

void pullBack(const CellMap& map, const double* vector, double* result)
{
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        map.inverse[3 * i] * vector[0] + map.inverse[3 * i + 1] * vector[1] + map.inverse[3 * i + 2] * vector[2];
}

} // namespace

DenseMatrix pulledBack(const CellMap& map, const DenseMatrix& columns)
{
  DenseMatrix result(columns.rows(), columns.cols());
  for (int j = 0; j < columns.cols(); ++j)
    for (int at = 0; at < columns.rows(); at += 3)
      pullBack(map, columns.col(j) + at, result.col(j) + at);
  return result;
}

StressMatrices::StressMatrices(const StarBody& body, const std::function<void(int, const DenseMatrix&)>& use)
    : body_(&body)
{
  const Mesh& mesh = body.model().mesh;
  const ReferenceStress& reference = body.reference();
  const int cells = mesh.numCells(), tractions = reference.tractions, data = reference.data();
  const std::size_t size = std::size_t(tractions) * std::size_t(data);
  const CellForms forms(reference);
  matrices_.resize(std::size_t(cells) * size);
  for (int first = 0; first < cells; first += together) {
    DenseMatrix compliances(int(reference.energy.size()), std::min(together, cells - first));
    for (int c = 0; c < compliances.cols(); ++c) {
      maps_.push_back(cellMap(mesh, sortedCell(mesh, first + c)));
      const auto entries = pulledBackCompliance(maps_.back(), body.model().laws(first + c));
      std::copy(entries.begin(), entries.end(), compliances.col(c));
    }
    forms.each(compliances, [&](int c, const DenseMatrix& A) {
      float* matrix = matrices_.data() + std::size_t(first + c) * size;
      for (int j = 0; j < data; ++j)
        for (int i = 0; i < tractions; ++i)
          *matrix++ = float(A(i, j));
      use(first + c, A);
    });
  }
}

void StressMatrices::multiply(int cell, const double* x, int count, double* forces) const
{
  constexpr std::size_t mostData = 128;
  const auto rows = std::size_t(body_->reference().tractions), data = std::size_t(body_->reference().data());
  std::array<float, mostData> from{}, to{};
  NDFRAME_ASSERT(data <= mostData, "more data than a cell of degree 2 has");
  const CellMap& map = maps_[std::size_t(cell)];
  for (std::size_t at = 0; at < std::size_t(count); at += 3) {
    double local[3];
    pullBack(map, x + at, local);
    for (std::size_t i = 0; i < 3; ++i)
      from[at + i] = float(local[i]);
  }
  const float* A = matrices_.data() + std::size_t(cell) * rows * data;
  for (std::size_t j = 0; j < std::size_t(count); ++j, A += rows) {
    const float factor = from[j];
    for (std::size_t i = 0; i < rows; ++i)
      to[i] += A[i] * factor;
  }
  for (std::size_t at = 0; at < rows; at += 3)
    for (std::size_t i = 0; i < 3; ++i)
      forces[at + i] = map.inverse[i] * double(to[at]) + map.inverse[3 + i] * double(to[at + 1]) +
                       map.inverse[6 + i] * double(to[at + 2]);
}

} // namespace ndframe
