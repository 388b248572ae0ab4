#pragma once

#include "batched_kernels.hpp"
#include "lanes.hpp"

// Part of the kernels' translation units (see lanes.hpp): the energy of one cell of a star.

namespace ndframe
{
namespace
{

template <int q>
struct Sizes
{
  static constexpr int modes = spokeModes(q);      ///< self-equilibrated modes of a spoke
  static constexpr int unknowns = cellUnknowns(q); ///< w, s_1, s_2
  static constexpr int bubbles = cellBubbles(q);
  static constexpr int facetData = 2 * (q + 1);
  static constexpr int firstSpoke = 3, secondSpoke = 3 + modes;
  static constexpr int maxLoads = 2 * (loadModesOf(q) + q + 1); ///< sweeps: loads and rim
};

/// A cell seen from the star's vertex: x = x_a + d1 X_1 + d2 X_2.
struct CellShape
{
  Vector2 d1, d2;
  Lanes det, inverse; ///< d1 x d2 > 0 and its reciprocal

  CellShape(Vector2 first, Vector2 second) : d1(first), d2(second), det(cross(first, second)), inverse(1.0 / det) {}

  /// F^-1 v.
  Vector2 pullBack(Vector2 v) const { return inverse * Vector2{cross(v, d2), cross(d1, v)}; }
  /// The tangential share of a moment mode that points along the other spoke: what the wrench needs of L_1 t apart from
  /// n L_1 (the two spokes' cells must agree, so it is n, not the median, that carries the moment).
  Lanes slant1() const { return -dot(d1, d2) / dot(d1, d1); }
  Lanes slant2() const { return -dot(d1, d2) / dot(d2, d2); }
};

/// Entries of the compliance in reference axes over |det F|, the factors of the six tables.
inline void pullBackCompliance(const CellShape& shape, const double* C, Lanes* c)
{
  const Vector2 a = shape.d1, b = shape.d2;
  const Lanes S[3][3] = {{a.x * a.x, a.y * a.y, a.x * a.y},
                         {b.x * b.x, b.y * b.y, b.x * b.y},
                         {2.0 * a.x * b.x, 2.0 * a.y * b.y, a.x * b.y + a.y * b.x}};
  for (int i = 0, entry = 0; i < 3; ++i) {
    const Lanes xx = shape.inverse * (C[0] * S[i][0] + C[1] * S[i][1] + C[2] * S[i][2]);
    const Lanes yy = shape.inverse * (C[1] * S[i][0] + C[3] * S[i][1] + C[4] * S[i][2]);
    const Lanes xy = shape.inverse * (C[2] * S[i][0] + C[4] * S[i][1] + C[5] * S[i][2]);
    for (int j = i; j < 3; ++j, ++entry)
      c[entry] = xx * S[j][0] + yy * S[j][1] + xy * S[j][2];
  }
}

inline Lanes combine(const double* table, const Lanes* c)
{
  return (table[0] * c[0] + table[1] * c[1] + table[2] * c[2]) + (table[3] * c[3] + table[4] * c[4] + table[5] * c[5]);
}

/// Change of unknowns from those that all cells of a star share to a cell's reference axes, z^ = B z.
template <int q>
class AxesChange
{
public:
  AxesChange(const StarTables& tables, const CellShape& shape)
      : x_(-shape.inverse * dot(shape.d1, shape.d2)), y1_(shape.inverse * dot(shape.d1, shape.d1)),
        y2_(-shape.inverse * dot(shape.d2, shape.d2)), bend1_(0.5 / tables.arm * shape.slant1()),
        bend2_(0.5 / tables.arm * shape.slant2()), d1_(shape.inverse * shape.d1), d2_(shape.inverse * shape.d2),
        inverse_(shape.inverse)
  {}

  /// v := B^T v, entries `stride` apart; only from the spokes on when the wrench's entries are not wanted.
  void transpose(Lanes* v, int stride, bool withWrench) const
  {
    const auto at = [v, stride](int i) -> Lanes& { return v[i * stride]; };
    if (withWrench) {
      const Lanes moment1 = bend1_ * at(first), moment2 = bend2_ * at(second);
      const Lanes f1 = at(0) - moment2, f2 = at(1) - moment1;
      at(0) = d2_.y * f1 - d1_.y * f2;
      at(1) = d1_.x * f2 - d2_.x * f1;
      at(2) = inverse_ * (at(2) + 2.0 * (moment1 - moment2));
    }
    for (int t = 1; t < Sizes<q>::modes; t += 2) {
      at(first + t + 1) = y1_ * at(first + t + 1) + x_ * at(first + t);
      at(second + t + 1) = y2_ * at(second + t + 1) - x_ * at(second + t);
    }
  }

private:
  static constexpr int first = Sizes<q>::firstSpoke, second = Sizes<q>::secondSpoke;
  Lanes x_, y1_, y2_;   ///< n of each spoke in reference axes
  Lanes bend1_, bend2_; ///< tangential moment modes that go with a wrench
  Vector2 d1_, d2_;
  Lanes inverse_;
};

/// Second derivatives of a cell's energy (over 2) with respect to its unknowns, and to unknowns and loads (these in
/// reference axes).
template <int q>
struct CellForm
{
  static constexpr int n = Sizes<q>::unknowns, bubbles = Sizes<q>::bubbles, rows = bubbles + n;
  static constexpr int maxLoads = Sizes<q>::maxLoads;
  Lanes A[n][n]; ///< upper triangle
  Lanes load[n][maxLoads];

  CellForm(const StarTables& tables, const LoadModes& loads, const CellShape& shape)
  {
    Lanes c[6];
    pullBackCompliance(shape, tables.compliance, c);
    fromTables(tables.form, loads, c);
    const AxesChange<q> axes(tables, shape);
    for (int j = 0; j < n; ++j)
      axes.transpose(&A[0][j], n, true);
    for (int j = 0; j < 2 * loads.modes; ++j)
      axes.transpose(&load[0][j], maxLoads, true);
    for (int i = 0; i < n; ++i)
      axes.transpose(A[i], 1, i < 3);
  }

private:
  /// In reference axes, bubbles eliminated; left-looking, so that each entry is written once.
  void fromTables(const double* form, const LoadModes& loads, const Lanes* c)
  {
    Lanes U[bubbles + 1][rows + maxLoads], f[bubbles + 1], inverse[bubbles + 1];
    const int columns = 2 * loads.modes;
    const double* coupling = loads.coupling;
    for (int r = 0; r < bubbles; ++r) {
      for (int b = 0; b < r; ++b)
        f[b] = U[b][r] * inverse[b];
      for (int j = r; j < rows; ++j, form += 6)
        U[r][j] = eliminated(combine(form, c), r, f, &U[0][j]);
      for (int j = rows; j < rows + columns; ++j, coupling += 6)
        U[r][j] = eliminated(combine(coupling, c), r, f, &U[0][j]);
      inverse[r] = 1.0 / U[r][r];
    }
    for (int r = 0; r < n; ++r) {
      for (int b = 0; b < bubbles; ++b)
        f[b] = U[b][bubbles + r] * inverse[b];
      for (int j = r; j < n; ++j, form += 6)
        A[r][j] = A[j][r] = eliminated(combine(form, c), bubbles, f, &U[0][bubbles + j]);
      for (int j = 0; j < columns; ++j, coupling += 6)
        load[r][j] = eliminated(combine(coupling, c), bubbles, f, &U[0][rows + j]);
    }
  }

  /// entry - sum_b f_b U_bj, U_bj below each other from `column`.
  static Lanes eliminated(Lanes entry, int count, const Lanes* f, const Lanes* column)
  {
    for (int b = 0; b < count; ++b)
      entry -= f[b] * column[b * (rows + maxLoads)];
    return entry;
  }
};

} // namespace
} // namespace ndframe
