#pragma once

#include "batched_form.hpp"
#include "batched_solution.hpp"

// Part of the kernels' translation units (see lanes.hpp): cells by themselves.

namespace ndframe
{
namespace
{

/// Strains (xx, yy, 2 xy) at the three vertices of a displacement of order 2.
/// v: at the vertices, then at the middles of the edges opposite to them.
inline void vertexStrains(const CellShape& shape, const Lanes* v, Lanes (&strain)[3][3])
{
  const Vector2 v0 = load2(v), v1 = load2(v + 2), v2 = load2(v + 4);
  const Vector2 opposite0 = load2(v + 6), opposite1 = load2(v + 8), opposite2 = load2(v + 10);
  // Derivatives along d1, d2 at each vertex.
  const Vector2 along[3][2] = {{4.0 * opposite2 - 3.0 * v0 - v1, 4.0 * opposite1 - 3.0 * v0 - v2},
                               {3.0 * v1 + v0 - 4.0 * opposite2, 4.0 * (opposite0 - opposite2) + v0 - v2},
                               {4.0 * (opposite0 - opposite1) + v0 - v1, 3.0 * v2 + v0 - 4.0 * opposite1}};
  for (int a = 0; a < 3; ++a) {
    const Vector2 dx = shape.inverse * (shape.d2.y * along[a][0] - shape.d1.y * along[a][1]);
    const Vector2 dy = shape.inverse * (shape.d1.x * along[a][1] - shape.d2.x * along[a][0]);
    strain[a][0] = dx.x;
    strain[a][1] = dy.y;
    strain[a][2] = dx.y + dy.x;
  }
}

/// matrix: upper triangle of a symmetric 3 x 3 matrix, row by row.
template <class Entry>
void multiply3(const Entry* matrix, const Lanes* x, Lanes* y)
{
  y[0] = matrix[0] * x[0] + matrix[1] * x[1] + matrix[2] * x[2];
  y[1] = matrix[1] * x[0] + matrix[3] * x[1] + matrix[4] * x[2];
  y[2] = matrix[2] * x[0] + matrix[4] * x[1] + matrix[5] * x[2];
}

inline CellShape shapeOf(const CellBatch& batch)
{
  return {load2(lanes(batch.edges)), load2(lanes(batch.edges) + 2)};
}

inline void vertexStress(const double* stiffness, const CellBatch& batch)
{
  Lanes strain[3][3];
  vertexStrains(shapeOf(batch), lanes(batch.displacement), strain);
  for (int a = 0; a < 3; ++a)
    multiply3(stiffness, strain[a], lanes(batch.stress) + 3 * a);
}

/// int K eps(v) : eps(v); the strain is linear, the rule of the mid-edge points exact.
inline Lanes strainEnergy(const CellTables& tables, const CellShape& shape, const Lanes* v)
{
  Lanes strain[3][3], stress[3], sum{};
  vertexStrains(shape, v, strain);
  for (int a = 0; a < 3; ++a) {
    Lanes middle[3];
    for (int i = 0; i < 3; ++i)
      middle[i] = 0.5 * (strain[a][i] + strain[(a + 1) % 3][i]);
    multiply3(tables.stiffness, middle, stress);
    for (int i = 0; i < 3; ++i)
      sum += middle[i] * stress[i];
  }
  return absolute(shape.det) / 6.0 * sum;
}

/// int c : eps(v) = int_dE c n . v - int div c . v.
template <int q>
Lanes work(const CellTables& tables, const Lanes* data, const Lanes* v)
{
  constexpr int facetNodes[3][3] = {{1, 2, 3}, {0, 2, 4}, {0, 1, 5}};
  Lanes sum{};
  for (int facet = 0; facet < 3; ++facet)
    for (int mode = 0; mode <= q; ++mode, data += 2)
      for (int a = 0; a < 3; ++a)
        sum += tables.facetWork[mode * 3 + a] * dot(load2(data), load2(v + 2 * facetNodes[facet][a]));
  for (int mode = 0; mode < loadModesOf(q); ++mode, data += 2)
    for (int a = 0; a < 6; ++a)
      sum -= tables.loadWork[mode * 6 + a] * dot(load2(data), load2(v + 2 * a));
  return sum;
}

/// |c|^2 in the complementary energy norm: the energy of the lift less what the bubbles gain.
template <int q>
Lanes correctionEnergy(const CellTables& tables, const CellShape& shape, const Lanes* data)
{
  constexpr int values = 3 * Sizes<q>::facetData + 2 * loadModesOf(q), bubbles = Sizes<q>::bubbles;
  constexpr int coefficients = 3 * (q + 1) * (q + 2) / 2;
  Lanes c[6], x[values], gain[bubbles + 1] = {}, energy{};
  pullBackCompliance(shape, tables.compliance, c);
  for (int i = 0; i < values; i += 2)
    store2(x + i, shape.pullBack(load2(data + i)));
  const double *lift = tables.lift, *bubble = tables.bubble;
  for (int i = 0; i < coefficients; ++i) {
    Lanes S[3] = {}, strain[3];
    for (int j = 0; j < values; ++j, lift += 3)
      for (int a = 0; a < 3; ++a)
        S[a] += lift[a] * x[j];
    multiply3(c, S, strain);
    energy += S[0] * strain[0] + S[1] * strain[1] + S[2] * strain[2];
    for (int b = 0; b < bubbles; ++b, bubble += 3)
      gain[b] += bubble[0] * strain[0] + bubble[1] * strain[1] + bubble[2] * strain[2];
  }
  if constexpr (bubbles > 0) {
    Lanes A[bubbles][bubbles], y[bubbles];
    const double* form = tables.bubbleForm;
    for (int b = 0; b < bubbles; ++b) {
      y[b] = gain[b];
      for (int j = b; j < bubbles; ++j, form += 6)
        A[b][j] = combine(form, c);
    }
    factor(A);
    minimise(A, y);
    for (int b = 0; b < bubbles; ++b)
      energy += gain[b] * y[b];
  }
  return shape.det < 0.0 ? -energy : energy; // c was divided by det, not by its modulus
}

/// |c|^2 + 2 <c, eps(v)> + |eps(v)|^2.
template <int q>
void distance(const CellTables& tables, const CellBatch& batch)
{
  const CellShape shape = shapeOf(batch);
  const Lanes* data = lanes(batch.data);
  Lanes sum = correctionEnergy<q>(tables, shape, data);
  if (batch.displacement != nullptr) {
    const Lanes* v = lanes(batch.displacement);
    sum += 2.0 * work<q>(tables, data, v) + strainEnergy(tables, shape, v);
  }
  // A square, but for round-off.
  lanes(batch.distance)[0] = sum < 0.0 ? Lanes{} : sum;
}

} // namespace
} // namespace ndframe
