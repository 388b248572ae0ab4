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

inline CellShape shapeOf(const CellBatch& batch)
{
  return {load2(lanes(batch.edges)), load2(lanes(batch.edges) + 2)};
}

/// K eps(v) at the vertices.
template <class Number>
void elasticStress(const Number* stiffness, const CellShape& shape, const Lanes* v, Lanes (&stress)[3][3])
{
  Lanes strain[3][3];
  vertexStrains(shape, v, strain);
  for (int a = 0; a < 3; ++a)
    multiply3(stiffness, strain[a], stress[a]);
}

inline void vertexStress(const PlaneLaw& law, const CellBatch& batch)
{
  Lanes stress[3][3];
  if (batch.law == nullptr)
    elasticStress(law.stiffness, shapeOf(batch), lanes(batch.displacement), stress);
  else
    elasticStress(lanes(batch.law) + 6, shapeOf(batch), lanes(batch.displacement), stress);
  for (int i = 0; i < 9; ++i)
    lanes(batch.stress)[i] = stress[i / 3][i % 3];
}

/// The bubbles of least energy, added to the coefficients of a stress in reference axes.
template <int q, class Number>
void addBubbles(const CellTables& tables, const Number* compliance, const CellShape& shape,
                Lanes (&S)[Sizes<q>::coefficients][3])
{
  constexpr int bubbles = Sizes<q>::bubbles;
  Lanes c[6], A[bubbles][bubbles], y[bubbles] = {};
  pullBackCompliance(shape, compliance, c);
  const double *bubble = tables.bubble, *form = tables.bubbleForm;
  for (const auto& coefficient : S) {
    Lanes strain[3];
    multiply3(c, coefficient, strain);
    for (int b = 0; b < bubbles; ++b, bubble += 3)
      y[b] += bubble[0] * strain[0] + bubble[1] * strain[1] + bubble[2] * strain[2];
  }
  for (int b = 0; b < bubbles; ++b)
    for (int j = b; j < bubbles; ++j, form += 6)
      A[b][j] = combine(form, c);
  factor(A);
  minimise(A, y);
  bubble = tables.bubble;
  for (auto& coefficient : S)
    for (int b = 0; b < bubbles; ++b, bubble += 3)
      add3(bubble, y[b], coefficient);
}

/// Coefficients of a correction in reference axes from its data, of which those before `begin` are zero.
template <int q, class Number>
void findStress(const CellTables& tables, const Number* compliance, const CellShape& shape, const Lanes* data,
                int begin, Lanes (&S)[Sizes<q>::coefficients][3])
{
  constexpr int values = 3 * Sizes<q>::facetData + 2 * loadModesOf(q);
  Lanes x[values];
  for (int i = begin; i < values; i += 2)
    store2(x + i, shape.pullBack(load2(data + i)));
  // Three coefficients side by side: one alone would wait for its own sums.
  const double* lift = tables.lift;
  for (int i = 0; i < Sizes<q>::coefficients; i += 3, lift += 9 * values) {
    Lanes first[3] = {}, second[3] = {}, third[3] = {};
    for (int j = begin; j < values; ++j) {
      add3(lift + 3 * j, x[j], first);
      add3(lift + 3 * (values + j), x[j], second);
      add3(lift + 3 * (2 * values + j), x[j], third);
    }
    copy3(first, S[i]);
    copy3(second, S[i + 1]);
    copy3(third, S[i + 2]);
  }
  if constexpr (Sizes<q>::bubbles > 0)
    addBubbles<q>(tables, compliance, shape, S);
}

/// |c + K eps(v)|^2 as a sum of squares: one that is small beside |c|^2 and |K eps(v)|^2 comes out right as well.
template <int q, class Number>
void distance(const CellTables& tables, const Number* compliance, const Number* stiffness, const Number* root,
              const CellBatch& batch)
{
  constexpr int modes = Sizes<q>::coefficients / 3;
  const CellShape shape = shapeOf(batch);
  Lanes S[Sizes<q>::coefficients][3], axes[3][3], elastic[3][3] = {}, sum{};
  findStress<q>(tables, compliance, shape, lanes(batch.data), batch.firstData, S);
  pushForward(shape, axes);
  if (batch.displacement != nullptr)
    elasticStress(stiffness, shape, lanes(batch.displacement), elastic);
  const Lanes inverse = absolute(shape.inverse);
  for (int i = 0; i < Sizes<q>::coefficients; ++i) {
    Lanes sigma[3] = {};
    for (int a = 0; a < 3; ++a)
      add3(axes[a], inverse * S[i][a], sigma);
    if (batch.displacement != nullptr && i % modes < 3)
      for (int vertex = 0; vertex < 3; ++vertex)
        add3(elastic[vertex], tables.linear[(i / modes * 3 + i % modes) * 3 + vertex], sigma);
    sum += square(root, sigma);
  }
  lanes(batch.distance)[0] = absolute(shape.det) * sum;
}

template <int q>
void distance(const CellTables& tables, const CellBatch& batch)
{
  const PlaneLaw& law = tables.law;
  if (batch.law == nullptr)
    distance<q>(tables, law.compliance, law.stiffness, law.root, batch);
  else
    distance<q>(tables, lanes(batch.law), lanes(batch.law) + 6, lanes(batch.law) + 12, batch);
}

} // namespace
} // namespace ndframe
