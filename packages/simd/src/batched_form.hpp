#pragma once

#include "batched_shape.hpp"

// Part of the kernels' translation units (see lanes.hpp): the energy of one cell of a star.

namespace ndframe
{
namespace
{

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

  /// compliance: of the cell; null for that of the tables.
  CellForm(const StarTables& tables, const LoadModes& loads, const CellShape& shape, const Lanes* compliance)
  {
    Lanes c[6];
    if (compliance == nullptr)
      pullBackCompliance(shape, tables.compliance, c);
    else
      pullBackCompliance(shape, compliance, c);
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
