#include <algorithm>
#include <cmath>
#include <cstring>

#include "cell_forms_kernels.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = CellForms::lanes, mostTractions = 72;

typedef float Floats __attribute__((vector_size(sizeof(float) * lanes)));

/// Rounds numbers side by side, each lane times its scale.
NDFRAME_EVERY_PROCESSOR void roundLanes(const double* from, const double* scale, std::size_t count, Floats* to)
{
  DoubleLanes value, factor;
  load(scale, factor);
  for (std::size_t i = 0; i < count; ++i) {
    load(from + i * lanes, value);
    to[i] = __builtin_convertvector(value * factor, Floats);
  }
}

/// multiplyTable, for up to six rows at once.
NDFRAME_EVERY_PROCESSOR void multiply(const float* table, std::size_t stride, std::size_t rows, std::size_t columns,
                                      const Floats* x, Floats* y)
{
  constexpr std::size_t together = 6;
  for (std::size_t i = 0; i < rows; i += together, table += together * stride, y += together) {
    Floats sums[together] = {};
    for (std::size_t j = 0; j < columns; ++j) {
      const Floats value = x[j];
#pragma GCC unroll 6
      for (std::size_t k = 0; k < together; ++k)
        sums[k] += table[k * stride + j] * value;
    }
    for (std::size_t k = 0; k < together; ++k)
      y[k] = sums[k];
  }
}

/// Stresses become what they do work with; stress: by sub-cell, component, function.
NDFRAME_EVERY_PROCESSOR void weigh(const Floats* compliances, std::size_t modes, Floats* stress)
{
  constexpr float weight = 1.0F / 6.0F / float(subCells); // of the reference tetrahedron
  Floats C[strains][strains], given[strains];
  for (std::size_t a = 0; a < strains; ++a)
    for (std::size_t b = a; b < strains; ++b)
      C[b][a] = C[a][b] = weight * *compliances++;
  for (std::size_t sub = 0; sub < subCells; ++sub, stress += strains * modes)
    for (std::size_t m = 0; m < modes; ++m) {
      for (std::size_t a = 0; a < strains; ++a)
        given[a] = stress[a * modes + m];
      for (std::size_t a = 0; a < strains; ++a) {
        Floats sum{};
        for (std::size_t b = 0; b < strains; ++b)
          sum += C[a][b] * given[b];
        stress[a * modes + m] = sum;
      }
    }
}

NDFRAME_EVERY_PROCESSOR void solveRounded(const Floats* L, Floats* y)
{
  solveNegative(L, y);
}

/// Per lane 1 / the largest of some numbers; 1 where all are 0.
void findScales(const double* values, std::size_t count, double* scales)
{
  std::fill_n(scales, lanes, 0.0);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      scales[lane] = std::max(scales[lane], std::abs(values[i * lanes + lane]));
  for (std::size_t lane = 0; lane < lanes; ++lane)
    scales[lane] = scales[lane] > 0.0 ? 1.0 / scales[lane] : 1.0;
}

/// L of bb times s: off the diagonal times sqrt(s), on it, where inverses are, by sqrt(s).
void roundFactor(const double* factor, const double* scales, float* L)
{
  double root[lanes], inverse[lanes];
  for (std::size_t lane = 0; lane < lanes; ++lane)
    inverse[lane] = 1.0 / (root[lane] = std::sqrt(scales[lane]));
  for (std::size_t b = 0; b < bubbles; ++b)
    for (std::size_t i = b; i < bubbles; ++i, factor += lanes, L += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane)
        L[lane] = float(factor[lane] * (i == b ? inverse[lane] : root[lane]));
}

} // namespace

void CellForms::round(const double* compliances, const double* factor, float* numbers, double* scales) const
{
  findScales(compliances, terms, scales);
  for (std::size_t i = 0; i < terms * lanes; ++i)
    numbers[i] = float(compliances[i] * scales[i % lanes]);
  if (reference_.bubbles > 0)
    roundFactor(factor, scales, numbers + terms * lanes);
}

void CellForms::applyRounded(const float* numbers, const double* ofCompliances, const double* T, double* forces) const
{
  const auto coefficients = std::size_t(reference_.coefficients), tractions = std::size_t(reference_.tractions);
  const auto modes = std::size_t(reference_.basis.size());
  double ofTractions[lanes];
  findScales(T, tractions, ofTractions);
  Floats C[terms], x[mostTractions], stress[mostCoefficients];
  std::memcpy(C, numbers, sizeof(C));
  roundLanes(T, ofTractions, tractions, x);
  multiply(liftRounded_.data(), tractions, coefficients, tractions, x, stress);
  weigh(C, modes, stress);
  if (reference_.bubbles > 0) {
    Floats inside[mostCoefficients], L[factorEntries], y[bubbles];
    std::memcpy(L, numbers + terms * lanes, sizeof(L));
    multiply(bubbledRounded_.data(), coefficients, bubbles, coefficients, stress, y);
    solveRounded(L, y);
    multiply(bubbleRounded_.data(), bubbles, coefficients, bubbles, y, inside);
    weigh(C, modes, inside);
    for (std::size_t i = 0; i < coefficients; ++i)
      stress[i] += inside[i];
  }
  multiply(liftedRounded_.data(), coefficients, tractions, coefficients, stress, x);
  for (std::size_t i = 0; i < tractions; ++i)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      forces[i * lanes + lane] = double(x[i][lane]) / (ofCompliances[lane] * ofTractions[lane]);
}

} // namespace ndframe
