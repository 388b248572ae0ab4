#include "ndframe/equilibrium/cell_forms.hpp"

#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellForms::CellForms(const ReferenceStress& reference) : reference_(reference)
{
  const int size = reference.data() + reference.bubbles;
  table_ = DenseMatrix(size * (size + 1) / 2, int(reference.energy.size()));
  for (int m = 0; m < table_.cols(); ++m) {
    double* entry = table_.col(m);
    for (int j = 0; j < size; ++j)
      for (int i = j; i < size; ++i)
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
