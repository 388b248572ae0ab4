#include "ndframe/equilibrium/cell_forms.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellForms::CellForms(const ReferenceStress& reference) : reference_(reference)
{
  const int data = reference.data(), size = data + reference.bubbles;
  ofBubbles_ = DenseMatrix(reference.bubbles * data + reference.bubbles * (reference.bubbles + 1) / 2,
                           int(reference.energy.size()));
  table_ = DenseMatrix(size * (size + 1) / 2, int(reference.energy.size()));
  for (int m = 0; m < table_.cols(); ++m) {
    double* entry = table_.col(m);
    for (int j = 0; j < size; ++j)
      for (int i = j; i < size; ++i)
        *entry++ = reference.energy[std::size_t(m)](i, j);
    entry = ofBubbles_.col(m);
    for (int j = 0; j < size; ++j)
      for (int i = std::max(j, data); i < size; ++i)
        *entry++ = reference.energy[std::size_t(m)](i, j);
  }
}

/// packed: the lower triangle of [dd bd^T; bd bb]. With bb = L L^T the bubbles leave dd - Y^T Y, Y = L^-1 bd.
void CellForms::condense(const double* packed, DenseMatrix& A) const
{
  const int data = reference_.data(), bubbles = reference_.bubbles;
  DenseMatrix Y(data, bubbles), L(bubbles, bubbles); // Y by rows of bd
  for (int j = 0; j < data; ++j) {
    for (int i = j; i < data; ++i)
      A(i, j) = A(j, i) = *packed++;
    for (int b = 0; b < bubbles; ++b)
      Y(j, b) = *packed++;
  }
  for (int j = 0; j < bubbles; ++j)
    for (int i = j; i < bubbles; ++i)
      L(i, j) = *packed++;
  for (int b = 0; b < bubbles; ++b) {
    double* row = Y.col(b);
    for (int k = 0; k < b; ++k) {
      const double factor = L(b, k);
      const double* done = Y.col(k);
      for (int i = 0; i < data; ++i)
        row[i] -= factor * done[i];
      for (int i = b; i < bubbles; ++i)
        L(i, b) -= factor * L(i, k);
    }
    NDFRAME_ASSERT(L(b, b) > 0.0, "the energy of bubbles is positive");
    const double pivot = 1.0 / std::sqrt(L(b, b));
    for (int i = b; i < bubbles; ++i)
      L(i, b) *= pivot;
    for (int i = 0; i < data; ++i)
      row[i] *= pivot;
  }
  subtractSquare(Y, A);
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

void CellForms::each(const DenseMatrix& compliances, const std::function<void(int, const DenseMatrix&)>& use) const
{
  const DenseMatrix packed = multiply(table_, compliances);
  DenseMatrix A(reference_.data(), reference_.data());
  for (int cell = 0; cell < packed.cols(); ++cell) {
    condense(packed.col(cell), A);
    use(cell, A);
  }
}

} // namespace ndframe
