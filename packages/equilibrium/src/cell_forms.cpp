#include "ndframe/equilibrium/cell_forms.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellForms::CellForms(const ReferenceStress& reference) : reference_(reference)
{
  const int data = reference.data(), size = data + reference.bubbles;
  const auto addTo = [&](Vector& table, int i, int j) {
    for (const DenseMatrix& energy : reference.energy)
      table.push_back(energy(i, j));
  };
  const auto add = [&](int i, int j) { addTo(table_, i, j); };
  for (int i = 0; i < reference.coefficients; ++i) {
    for (int j = 0; j < data; ++j)
      lift_.push_back(reference.lift(i, j));
    for (int j = 0; j < reference.bubbles; ++j)
      bubble_.push_back(reference.bubble(i, j));
  }
  lifted_.assign(reference.lift.data(), reference.lift.data() + std::ptrdiff_t(reference.coefficients) * data);
  bubbled_.assign(reference.bubble.data(),
                  reference.bubble.data() + std::ptrdiff_t(reference.coefficients) * reference.bubbles);
  for (int i = 0; i < reference.coefficients; ++i)
    for (int j = 0; j < reference.tractions; ++j)
      liftRounded_.push_back(float(reference.lift(i, j)));
  liftedRounded_.assign(reference.lift.data(), reference.lift.col(reference.tractions));
  bubbleRounded_.assign(bubble_.begin(), bubble_.end());
  bubbledRounded_.assign(bubbled_.begin(), bubbled_.end());
  for (int j = 0; j < data; ++j)
    for (int i = j; i < data; ++i)
      add(i, j);
  for (int j = 0; j < size; ++j)
    for (int i = std::max(j, data); i < size; ++i)
      add(i, j);
  addFacets([&](int i, int j) { addTo(facetTable_, i, j); });
}

/// add(row, column) for all entries of Facets, then for those of bubbles.
template <class Add>
void CellForms::addFacets(const Add& add)
{
  const int of = reference_.tractions / 4, data = reference_.data(), size = data + reference_.bubbles;
  for (int f = 0; f < 4; ++f)
    for (int j = f * of; j < (f + 1) * of; ++j)
      for (int i = j; i < (f + 1) * of; ++i)
        add(i, j);
  for (int f = 0; f < 4; ++f)
    for (int g = f + 1; g < 4; ++g)
      for (int j = f * of; j < f * of + linear; ++j)
        for (int i = g * of; i < g * of + linear; ++i)
          add(i, j);
  for (int j = 0; j < reference_.tractions; ++j)
    for (int i = data; i < size; ++i)
      add(i, j);
  for (int j = data; j < size; ++j)
    for (int i = j; i < size; ++i)
      add(i, j);
}

const CellForms& solidForms(int degree)
{
  NDFRAME_ASSERT(degree == 1 || degree == 2, "stresses of whole solids have degree 1 or 2");
  if (degree == 1) {
    static const CellForms linear(referenceStress(3, 1));
    return linear;
  }
  static const CellForms quadratic(referenceStress(3, 2));
  return quadratic;
}

} // namespace ndframe
