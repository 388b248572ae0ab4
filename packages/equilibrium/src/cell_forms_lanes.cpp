#include <algorithm>
#include <cmath>

#include "cell_forms_kernels.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/lane_tables.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = CellForms::lanes;

/// result[i] = sum_m table[i][m] c[m]
NDFRAME_EVERY_PROCESSOR void combine(const double* table, std::size_t count, const double* c, double* result)
{
  DoubleLanes weights[terms];
  for (std::size_t m = 0; m < terms; ++m)
    load(c + m * lanes, weights[m]);
  for (std::size_t i = 0; i < count; ++i, table += terms, result += lanes) {
    DoubleLanes even = table[terms - 1] * weights[terms - 1], odd{};
#pragma GCC unroll 10
    for (std::size_t m = 0; m + 1 < terms; m += 2) {
      even += table[m] * weights[m];
      odd += table[m + 1] * weights[m + 1];
    }
    store(even + odd, result);
  }
}

/// bb = L L^T in place, from the columns below its diagonal; on it the inverses of those of L. Whether it is positive.
NDFRAME_EVERY_PROCESSOR bool factor(DoubleLanes* triangle)
{
  bool isPositive = true;
  DoubleLanes* columns[bubbles]; // row i of column b: columns[b][i]
  for (std::size_t b = 0; b < bubbles; triangle += bubbles - b, ++b)
    columns[b] = triangle - b;
  for (std::size_t b = 0; b < bubbles; ++b) {
    for (std::size_t k = 0; k < b; ++k)
      for (std::size_t i = b; i < bubbles; ++i)
        columns[b][i] -= columns[k][b] * columns[k][i];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      isPositive = isPositive && columns[b][b][lane] > 0.0;
      columns[b][b][lane] = 1.0 / std::sqrt(columns[b][b][lane]);
    }
    for (std::size_t i = b + 1; i < bubbles; ++i)
      columns[b][i] *= columns[b][b];
  }
  return isPositive;
}

/// Rows of bd^T become those of Y = bd^T L^-T, L as factor() leaves it.
NDFRAME_EVERY_PROCESSOR void eliminate(const DoubleLanes* triangle, std::size_t data, double* rows)
{
  DoubleLanes row[bubbles];
  for (std::size_t j = 0; j < data; ++j, rows += bubbles * lanes) {
    for (std::size_t b = 0; b < bubbles; ++b)
      load(rows + b * lanes, row[b]);
    const DoubleLanes* entry = triangle;
    for (std::size_t b = 0; b < bubbles; ++b) {
      row[b] *= *entry++;
      for (std::size_t i = b + 1; i < bubbles; ++i)
        row[i] -= *entry++ * row[b];
    }
    for (std::size_t b = 0; b < bubbles; ++b)
      store(row[b], rows + b * lanes);
  }
}

/// Lower triangle A -= Y Y^T, column by column.
NDFRAME_EVERY_PROCESSOR void subtractSquare(const double* Y, std::size_t data, double* A)
{
  DoubleLanes here[bubbles], other, entry;
  for (std::size_t j = 0; j < data; ++j) {
    for (std::size_t b = 0; b < bubbles; ++b)
      load(Y + (j * bubbles + b) * lanes, here[b]);
    for (std::size_t i = j; i < data; ++i, A += lanes) {
      const double* row = Y + i * bubbles * lanes;
      DoubleLanes sums[2] = {};
#pragma GCC unroll 18
      for (std::size_t b = 0; b < bubbles; ++b) {
        load(row + b * lanes, other);
        sums[b % 2] += other * here[b];
      }
      load(A, entry);
      store(entry - (sums[0] + sums[1]), A);
    }
  }
}

/// A -= X Y^T, column by column: columns by the first `count` rows X_j, rows by those of Y.
NDFRAME_EVERY_PROCESSOR void subtractProduct(const double* X, const double* Y, std::size_t count, double* A)
{
  DoubleLanes here[bubbles], other, entry;
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t b = 0; b < bubbles; ++b)
      load(X + (j * bubbles + b) * lanes, here[b]);
    for (std::size_t i = 0; i < count; ++i, A += lanes) {
      DoubleLanes sums[2] = {};
#pragma GCC unroll 18
      for (std::size_t b = 0; b < bubbles; ++b) {
        load(Y + (i * bubbles + b) * lanes, other);
        sums[b % 2] += other * here[b];
      }
      load(A, entry);
      store(entry - (sums[0] + sums[1]), A);
    }
  }
}

/// factor() of numbers in memory.
void factorStored(double* triangle)
{
  DoubleLanes L[factorEntries];
  std::memcpy(L, triangle, sizeof(L));
  const bool isPositive = factor(L);
  NDFRAME_ASSERT(isPositive, "the energy of bubbles is positive");
  std::memcpy(triangle, L, sizeof(L));
}

/// eliminate() with a triangle in memory.
void eliminateStored(const double* triangle, std::size_t data, double* rows)
{
  DoubleLanes L[factorEntries];
  std::memcpy(L, triangle, sizeof(L));
  eliminate(L, data, rows);
}

/// Stresses become what they do work with: on every sub-cell, for every function, the compliance times the weight that
/// makes the functions' products integrals. stress: by sub-cell, component, function.
NDFRAME_EVERY_PROCESSOR void weigh(const double* compliances, std::size_t modes, double* stress)
{
  constexpr double weight = 1.0 / 6.0 / double(subCells); // of the reference tetrahedron
  DoubleLanes C[strains][strains], given[strains];
  for (std::size_t a = 0; a < strains; ++a)
    for (std::size_t b = a; b < strains; ++b, compliances += lanes) {
      load(compliances, C[a][b]);
      C[a][b] *= weight;
      C[b][a] = C[a][b];
    }
  for (std::size_t sub = 0; sub < subCells; ++sub, stress += strains * modes * lanes)
    for (std::size_t m = 0; m < modes; ++m) {
      for (std::size_t a = 0; a < strains; ++a)
        load(stress + (a * modes + m) * lanes, given[a]);
      for (std::size_t a = 0; a < strains; ++a) {
        DoubleLanes sum{};
        for (std::size_t b = 0; b < strains; ++b)
          sum += C[a][b] * given[b];
        store(sum, stress + (a * modes + m) * lanes);
      }
    }
}

/// y := -bb^-1 y, with what factor() leaves.
NDFRAME_EVERY_PROCESSOR void solveStored(const double* triangle, double* values)
{
  DoubleLanes L[factorEntries], y[bubbles];
  std::memcpy(L, triangle, sizeof(L));
  std::memcpy(y, values, sizeof(y));
  solveNegative(L, y);
  std::memcpy(values, y, sizeof(y));
}

NDFRAME_EVERY_PROCESSOR void add(const double* values, std::size_t count, double* sum)
{
  for (std::size_t i = 0; i < count * lanes; ++i)
    sum[i] += values[i];
}

} // namespace

CellForms::Condensed CellForms::condensed(const double* compliances, Vector& work) const
{
  const auto data = std::size_t(reference_.data());
  const std::size_t triangle = data * (data + 1) / 2, entries = table_.size() / terms;
  NDFRAME_ASSERT(reference_.energy.size() == terms && (reference_.bubbles == 0 || reference_.bubbles == int(bubbles)),
                 "solids of degree 1 or 2");
  work.resize(entries * lanes);
  combine(table_.data(), entries, compliances, work.data());
  if (reference_.bubbles > 0) {
    double *rows = work.data() + triangle * lanes, *own = rows + data * bubbles * lanes;
    factorStored(own);
    eliminateStored(own, data, rows);
    subtractSquare(rows, data, work.data());
  }
  return {work.data(), work.data() + (entries - factorSize()) * lanes};
}

std::size_t CellForms::factorSize() const
{
  return reference_.bubbles > 0 ? factorEntries : 0;
}

/// The coefficients of the bubbles that go with a stress, from what it does work with.
void CellForms::findBubbles(const double* factor, const double* weighed, double* inside) const
{
  const auto coefficients = std::size_t(reference_.coefficients);
  double y[bubbles * lanes];
  multiplyTable(bubbled_.data(), coefficients, bubbles, coefficients, weighed, y);
  solveStored(factor, y);
  multiplyTable(bubble_.data(), bubbles, coefficients, bubbles, y, inside);
}

void CellForms::leastStress(const double* compliances, const double* data, double* stress) const
{
  const auto coefficients = std::size_t(reference_.coefficients), columns = std::size_t(reference_.data());
  multiplyTable(lift_.data(), columns, coefficients, columns, data, stress);
  if (reference_.bubbles == 0)
    return;
  double inside[mostCoefficients * lanes], own[factorEntries * lanes];
  combine(table_.data() + table_.size() - factorEntries * terms, factorEntries, compliances, own);
  factorStored(own);
  double weighed[mostCoefficients * lanes];
  std::copy_n(stress, coefficients * lanes, weighed);
  weigh(compliances, std::size_t(reference_.basis.size()), weighed);
  findBubbles(own, weighed, inside);
  add(inside, coefficients, stress);
}

CellForms::Facets CellForms::facets(const double* compliances, Vector& work) const
{
  const auto of = std::size_t(reference_.tractions) / 4, count = facetTable_.size() / terms;
  constexpr std::size_t few = linear, pair = few * few;
  const std::size_t alone = 4 * (of * (of + 1) / 2), pairs = 6 * pair;
  work.resize(count * lanes);
  combine(facetTable_.data(), count, compliances, work.data());
  double *rows = work.data() + (alone + pairs) * lanes, *own = work.data() + (count - factorSize()) * lanes;
  if (reference_.bubbles > 0) {
    factorStored(own);
    eliminateStored(own, 4 * of, rows);
    for (std::size_t f = 0; f < 4; ++f)
      subtractSquare(rows + f * of * bubbles * lanes, of, work.data() + f * (alone / 4) * lanes);
    double* entries = work.data() + alone * lanes;
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t g = f + 1; g < 4; ++g, entries += pair * lanes)
        subtractProduct(rows + f * of * bubbles * lanes, rows + g * of * bubbles * lanes, few, entries);
  }
  return {work.data(), work.data() + alone * lanes, own};
}

void CellForms::apply(const double* compliances, const double* factor, const double* x, std::size_t size,
                      double* forces) const
{
  const auto coefficients = std::size_t(reference_.coefficients);
  const auto modes = std::size_t(reference_.basis.size());
  double stress[mostCoefficients * lanes];
  multiplyTable(lift_.data(), std::size_t(reference_.data()), coefficients, size, x, stress);
  weigh(compliances, modes, stress);
  if (reference_.bubbles > 0) {
    double inside[mostCoefficients * lanes];
    findBubbles(factor, stress, inside);
    weigh(compliances, modes, inside);
    add(inside, coefficients, stress);
  }
  multiplyTable(lifted_.data(), coefficients, size, coefficients, stress, forces);
}

} // namespace ndframe
