#pragma once

#include "batched_kernels.hpp"
#include "lanes.hpp"

// Part of the kernels' translation units (see lanes.hpp): a cell's geometry.

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
  static constexpr int coefficients = 3 * (q + 1) * (q + 2) / 2; ///< of a stress component in the split cell
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

/// The stresses  F S F^T  of the unit stresses S = xx, yy, xy in reference axes.
inline void pushForward(const CellShape& shape, Lanes (&stress)[3][3])
{
  const Vector2 a = shape.d1, b = shape.d2;
  const Lanes columns[3][3] = {{a.x * a.x, a.y * a.y, a.x * a.y},
                               {b.x * b.x, b.y * b.y, b.x * b.y},
                               {2.0 * a.x * b.x, 2.0 * a.y * b.y, a.x * b.y + a.y * b.x}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      stress[i][j] = columns[i][j];
}

/// Entries of the compliance in reference axes over det F, the factors of the six tables.
template <class Number>
inline void pullBackCompliance(const CellShape& shape, const Number* compliance, Lanes* c)
{
  Lanes stress[3][3], strain[3];
  pushForward(shape, stress);
  for (int i = 0, entry = 0; i < 3; ++i) {
    multiply3(compliance, stress[i], strain);
    for (int j = i; j < 3; ++j, ++entry)
      c[entry] = shape.inverse * (strain[0] * stress[j][0] + strain[1] * stress[j][1] + strain[2] * stress[j][2]);
  }
}

/// |sigma|^2 of one coefficient in the complementary energy norm; root: lower triangle, row by row.
template <class Number>
Lanes square(const Number* root, const Lanes* sigma)
{
  const Lanes x = root[0] * sigma[0], y = root[1] * sigma[0] + root[2] * sigma[1];
  const Lanes z = root[3] * sigma[0] + root[4] * sigma[1] + root[5] * sigma[2];
  return x * x + y * y + z * z;
}

inline Lanes combine(const double* table, const Lanes* c)
{
  return (table[0] * c[0] + table[1] * c[1] + table[2] * c[2]) + (table[3] * c[3] + table[4] * c[4] + table[5] * c[5]);
}

} // namespace
} // namespace ndframe
