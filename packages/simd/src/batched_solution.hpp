#pragma once

#include "batched_chain.hpp"

// Part of the kernels' translation units (see lanes.hpp): from the border's unknowns to the tractions on all spokes.

namespace ndframe
{
namespace
{

/// A = L D L^T in place: reciprocal pivots on the diagonal, rows of D L^T beside them.
template <int n>
void factor(Lanes (&A)[n][n])
{
  for (int b = 0; b < n; ++b) {
    A[b][b] = 1.0 / A[b][b];
    for (int i = b + 1; i < n; ++i) {
      const Lanes f = A[b][i] * A[b][b];
      for (int j = i; j < n; ++j)
        A[i][j] -= f * A[b][j];
    }
  }
}

/// x := - A^-1 x.
template <int n>
void minimise(const Lanes (&A)[n][n], Lanes* x)
{
  for (int b = 0; b < n; ++b)
    for (int i = b + 1; i < n; ++i)
      x[i] -= A[b][i] * A[b][b] * x[b];
  for (int b = n - 1; b >= 0; --b) {
    Lanes sum = -x[b];
    for (int j = b + 1; j < n; ++j)
      sum -= A[b][j] * x[j];
    x[b] = A[b][b] * sum;
  }
}

/// Closed stars: the last spoke is the first, so w and s_0 are left.
template <int q>
void close(const StarBatch& batch)
{
  constexpr int m = Sizes<q>::modes, n = Sizes<q>::unknowns, left = n - m;
  const Border<q> border{lanes(batch.border), lanes(batch.gradient), batch.fields};
  Lanes A[left][left];
  for (int i = 0; i < left; ++i)
    for (int j = i; j < left; ++j) {
      A[i][j] = border.at(i, j);
      if (j >= 3)
        A[i][j] += border.at(i, j + m);
      if (i >= 3)
        A[i][j] += border.at(j, i + m) + border.at(i + m, j + m);
    }
  factor(A);
  for (int k = 0; k < batch.fields; ++k) {
    Lanes* x = lanes(batch.solution) + k * n;
    for (int i = 0; i < left; ++i)
      x[i] = border.gradient[k * n + i];
    for (int i = 3; i < left; ++i)
      x[i] += border.gradient[k * n + i + m];
    minimise(A, x);
    for (int i = 3; i < left; ++i)
      x[i + m] = x[i];
  }
}

/// Moments of the traction with wrench w and modes s on a spoke.
template <int q>
void compose(Vector2 d, double arm, const Lanes* w, const Lanes* s, Vector2* T)
{
  const Vector2 n = turned(d);
  T[0] = load2(w);
  T[1] = s[0] * d + ((w[2] - 0.5 * cross(d, T[0])) / (arm * dot(d, d))) * n;
  for (int k = 2; k <= q; ++k)
    T[k] = s[2 * k - 3] * d + s[2 * k - 2] * n;
}

/// Writes the traction on spoke i for the cells beside it.
template <int q>
void writeSpoke(const StarTables& tables, const StarBatch& batch, int k, int i, const Lanes* s)
{
  constexpr int data = Sizes<q>::facetData;
  const int spoke = k * (batch.cells + 1) + i;
  const bool isEnd = i == 0 || i == batch.cells;
  const Lanes *solution = lanes(batch.solution) + k * Sizes<q>::unknowns, *offset = lanes(batch.offsets) + 3 * spoke;
  const Lanes* jump = lanes(batch.jumps) + data * spoke;
  const Lanes w[3] = {solution[0] + offset[0], solution[1] + offset[1], solution[2] + offset[2]};
  Vector2 T[q + 1];
  compose<q>(load2(lanes(batch.spokes) + 2 * i), tables.arm, w, s, T);
  if (i > 0 || batch.closed) {
    const int before = i > 0 ? i - 1 : batch.cells - 1;
    Lanes* out = lanes(batch.tractions) + ((k * batch.cells + before) * 2 + 1) * data;
    for (int mode = 0; mode <= q; ++mode)
      store2(out + 2 * mode, T[mode]);
  }
  if (i < batch.cells) {
    Lanes* out = lanes(batch.tractions) + (k * batch.cells + i) * 2 * data;
    for (int mode = 0; mode <= q; ++mode) {
      const Vector2 other = isEnd && !batch.closed ? Vector2{} : load2(jump + 2 * mode);
      store2(out + 2 * mode, -1.0 * (T[mode] + other));
    }
  }
}

/// Back-substitution along the chain; border solution -> tractions.
template <int q>
void expand(const StarTables& tables, const StarBatch& batch)
{
  constexpr int m = Sizes<q>::modes, n = Sizes<q>::unknowns, first = Sizes<q>::firstSpoke;
  for (int k = 0; k < batch.fields; ++k) {
    const Lanes* border = lanes(batch.solution) + k * n;
    Lanes next[m], s[m];
    for (int b = 0; b < m; ++b)
      next[b] = border[first + m + b];
    if (!batch.closed)
      writeSpoke<q>(tables, batch, k, batch.cells, next);
    for (int i = batch.cells - 1; i > 0; --i) {
      const Lanes* panel = lanes(batch.panels) + (i - 1) * panelSize(q, batch.fields);
      const Lanes* inverse = panel + m * (m + n);
      for (int b = m - 1; b >= 0; --b) {
        const Lanes* row = panel + b * (m + n);
        Lanes sum = -inverse[m * (1 + k) + b];
        for (int j = b + 1; j < m; ++j)
          sum -= row[j] * s[j];
        for (int j = 0; j < n - m; ++j)
          sum -= row[m + j] * border[j];
        for (int j = 0; j < m; ++j)
          sum -= row[n + j] * next[j];
        s[b] = inverse[b] * sum;
      }
      writeSpoke<q>(tables, batch, k, i, s);
      for (int b = 0; b < m; ++b)
        next[b] = s[b];
    }
    writeSpoke<q>(tables, batch, k, 0, border + first);
  }
}

} // namespace
} // namespace ndframe
