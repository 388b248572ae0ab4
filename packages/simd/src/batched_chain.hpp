#pragma once

#include "batched_form.hpp"

// Part of the kernels' translation units (see lanes.hpp): the unknowns of a star, spoke after spoke.

namespace ndframe
{
namespace
{

/// Energy over the border (w, s_0, s_last) of the cells seen so far, and its gradient per field. A[i][j] for i <= j.
template <int q>
struct Border
{
  static constexpr int m = Sizes<q>::modes, n = Sizes<q>::unknowns;
  static constexpr int first = Sizes<q>::firstSpoke, last = Sizes<q>::secondSpoke;

  Lanes* A;
  Lanes* gradient;
  int fields;

  Lanes& at(int i, int j) const { return A[i * n + j]; }

  /// Adds the cell between the last spoke and the next one, which becomes the last: its own modes are eliminated and
  /// kept in `panel` (see panelSize).
  void add(const CellForm<q>& cell, const Lanes* cellGradient, Lanes* panel) const
  {
    eliminate(cell, cellGradient, panel);
    Lanes f[m];
    for (int i = 0; i < n; ++i) {
      for (int b = 0; b < m; ++b)
        f[b] = panel[b * (m + n) + m + i] * panel[m * (m + n) + b];
      for (int j = i; j < n; ++j) {
        Lanes sum = own(cell, i, j);
        for (int b = 0; b < m; ++b)
          sum -= f[b] * panel[b * (m + n) + m + j];
        at(i, j) = sum;
      }
      for (int k = 0; k < fields; ++k) {
        Lanes sum = i < last ? gradient[k * n + i] : Lanes{};
        if (i < first || i >= last)
          sum += cellGradient[k * n + i];
        for (int b = 0; b < m; ++b)
          sum -= f[b] * panel[m * (m + n + 1 + k) + b];
        gradient[k * n + i] = sum;
      }
    }
  }

private:
  /// Panel rows b over (last spoke, w, s_0, next spoke), then reciprocal pivots, then gradients.
  void eliminate(const CellForm<q>& cell, const Lanes* cellGradient, Lanes* panel) const
  {
    Lanes* inverse = panel + m * (m + n);
    for (int b = 0; b < m; ++b) {
      Lanes* row = panel + b * (m + n);
      for (int j = b; j < m; ++j)
        row[j] = at(last + b, last + j) + cell.A[first + b][first + j];
      for (int j = 0; j < 3; ++j)
        row[m + j] = at(j, last + b) + cell.A[j][first + b];
      for (int j = first; j < last; ++j)
        row[m + j] = at(j, last + b);
      for (int j = last; j < n; ++j)
        row[m + j] = cell.A[first + b][j];
      for (int k = 0; k < fields; ++k)
        inverse[m * (1 + k) + b] = gradient[k * n + last + b] + cellGradient[k * n + first + b];
      for (int p = 0; p < b; ++p) {
        const Lanes* above = panel + p * (m + n);
        const Lanes f = above[b] * inverse[p];
        for (int j = b; j < m + n; ++j)
          row[j] -= f * above[j];
        for (int k = 0; k < fields; ++k)
          inverse[m * (1 + k) + b] -= f * inverse[m * (1 + k) + p];
      }
      inverse[b] = 1.0 / row[b];
    }
  }

  /// What cell and border have themselves.
  Lanes own(const CellForm<q>& cell, int i, int j) const
  {
    if (j < first)
      return at(i, j) + cell.A[i][j];
    if (j < last)
      return at(i, j);
    return i < first || i >= last ? cell.A[i][j] : Lanes{};
  }
};

/// Gradient of a cell's energy (over 2) at its known data, per field.
template <int q>
void cellGradient(const CellForm<q>& cell, const StarBatch& batch, int c, Lanes* gradient)
{
  constexpr int n = Sizes<q>::unknowns;
  const int loads = 2 * batch.loads->modes;
  for (int k = 0; k < batch.fields; ++k) {
    const Lanes* known = lanes(batch.known) + (k * batch.cells + c) * (n + loads);
    for (int i = 0; i < n; ++i) {
      Lanes sum{};
      for (int j = 0; j < i; ++j)
        sum += cell.A[j][i] * known[j];
      for (int j = i; j < n; ++j)
        sum += cell.A[i][j] * known[j];
      for (int j = 0; j < loads; ++j)
        sum += cell.load[i][j] * known[n + j];
      gradient[k * n + i] = sum;
    }
  }
}

template <int q>
void condense(const StarTables& tables, const StarBatch& batch)
{
  constexpr int n = Sizes<q>::unknowns;
  const Lanes* spokes = lanes(batch.spokes);
  const Border<q> border{lanes(batch.border), lanes(batch.gradient), batch.fields};
  Lanes* gradient = lanes(batch.scratch);
  for (int c = 0; c < batch.cells; ++c) {
    const CellShape shape(load2(spokes + 2 * c), load2(spokes + 2 * c + 2));
    const CellForm<q> cell(tables, *batch.loads, shape,
                           batch.compliance == nullptr ? nullptr : lanes(batch.compliance) + 6 * c);
    if (c > 0) {
      cellGradient(cell, batch, c, gradient);
      border.add(cell, gradient, lanes(batch.panels) + (c - 1) * panelSize(q, batch.fields));
      continue;
    }
    cellGradient(cell, batch, c, border.gradient);
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j)
        border.at(i, j) = cell.A[i][j];
  }
}

} // namespace
} // namespace ndframe
