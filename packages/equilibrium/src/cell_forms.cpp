#include "ndframe/equilibrium/cell_forms.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellForms::CellForms(const ReferenceStress& reference) : reference_(reference)
{
  const int data = reference.data(), size = data + reference.bubbles;
  const auto add = [&](int i, int j) {
    for (const DenseMatrix& energy : reference.energy)
      table_.push_back(energy(i, j));
  };
  for (int i = 0; i < reference.coefficients; ++i) {
    for (int j = 0; j < reference.tractions; ++j)
      lift_.push_back(reference.lift(i, j));
    for (int j = 0; j < reference.bubbles; ++j)
      bubble_.push_back(reference.bubble(i, j));
  }
  lifted_.assign(reference.lift.data(), reference.lift.col(reference.tractions));
  bubbled_.assign(reference.bubble.data(),
                  reference.bubble.data() + std::ptrdiff_t(reference.coefficients) * reference.bubbles);
  for (int j = 0; j < data; ++j)
    for (int i = j; i < data; ++i)
      add(i, j);
  for (int j = 0; j < size; ++j)
    for (int i = std::max(j, data); i < size; ++i)
      add(i, j);
  const std::size_t terms = reference.energy.size(), own = std::size_t(data) * std::size_t(data + 1) / 2;
  ofBubbles_ = DenseMatrix(int(table_.size() / terms - own), int(terms));
  for (int m = 0; m < ofBubbles_.cols(); ++m)
    for (int i = 0; i < ofBubbles_.rows(); ++i)
      ofBubbles_(i, m) = table_[(own + std::size_t(i)) * terms + std::size_t(m)];
}

/// bubbles = - bb^-1 bd data.
void CellForms::addBubbles(const double* packed, const double* data, double* bubbles) const
{
  const int count = reference_.bubbles;
  for (int j = 0; j < reference_.data(); ++j)
    for (int b = 0; b < count; ++b)
      bubbles[b] -= *packed++ * data[j];
  DenseMatrix L(count, count);
  for (int j = 0; j < count; ++j)
    for (int i = j; i < count; ++i)
      L(i, j) = *packed++;
  for (int b = 0; b < count; ++b) {
    for (int k = 0; k < b; ++k) {
      for (int i = b; i < count; ++i)
        L(i, b) -= L(b, k) * L(i, k);
      bubbles[b] -= L(b, k) * bubbles[k];
    }
    NDFRAME_ASSERT(L(b, b) > 0.0, "the energy of bubbles is positive");
    const double pivot = 1.0 / std::sqrt(L(b, b));
    for (int i = b; i < count; ++i)
      L(i, b) *= pivot;
    bubbles[b] *= pivot;
  }
  for (int b = count - 1; b >= 0; --b) {
    for (int i = b + 1; i < count; ++i)
      bubbles[b] -= L(i, b) * bubbles[i];
    bubbles[b] /= L(b, b);
  }
}

DenseMatrix CellForms::coefficients(const DenseMatrix& compliances, const DenseMatrix& data) const
{
  DenseMatrix result = multiply(reference_.lift, data);
  if (reference_.bubbles == 0)
    return result;
  const DenseMatrix packed = multiply(ofBubbles_, compliances);
  DenseMatrix bubbles(reference_.bubbles, data.cols());
  for (int cell = 0; cell < data.cols(); ++cell)
    addBubbles(packed.col(cell), data.col(cell), bubbles.col(cell));
  const DenseMatrix inside = multiply(reference_.bubble, bubbles);
  for (int cell = 0; cell < data.cols(); ++cell)
    for (int i = 0; i < result.rows(); ++i)
      result(i, cell) += inside(i, cell);
  return result;
}

} // namespace ndframe
