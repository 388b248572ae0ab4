#include <algorithm>
#include <cmath>

#include "cell_forms_kernels.hpp"
#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/lane_tables.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = CellForms::lanes;

typedef float Floats __attribute__((vector_size(sizeof(float) * lanes)));

/// Stresses become what they do work with; stress: by sub-cell, component, function.
NDFRAME_EVERY_PROCESSOR void weigh(const float* compliances, std::size_t modes, float* stress)
{
  constexpr float weight = 1.0F / 6.0F / float(subCells); // of the reference tetrahedron
  Floats C[strains][strains], given[strains];
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
        Floats sum{};
        for (std::size_t b = 0; b < strains; ++b)
          sum += C[a][b] * given[b];
        store(sum, stress + (a * modes + m) * lanes);
      }
    }
}

NDFRAME_EVERY_PROCESSOR void solveRounded(const float* triangle, float* values)
{
  Floats L[factorEntries], y[bubbles];
  std::memcpy(L, triangle, sizeof(L));
  std::memcpy(y, values, sizeof(y));
  solveNegative(L, y);
  std::memcpy(values, y, sizeof(y));
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

void CellForms::applyRounded(const float* numbers, const float* T, float* forces) const
{
  const auto coefficients = std::size_t(reference_.coefficients), tractions = std::size_t(reference_.tractions);
  const auto modes = std::size_t(reference_.basis.size());
  float stress[mostCoefficients * lanes];
  multiplyTable(liftRounded_.data(), tractions, coefficients, tractions, T, stress);
  weigh(numbers, modes, stress);
  if (reference_.bubbles > 0) {
    float inside[mostCoefficients * lanes], y[bubbles * lanes];
    multiplyTable(bubbledRounded_.data(), coefficients, bubbles, coefficients, stress, y);
    solveRounded(numbers + terms * lanes, y);
    multiplyTable(bubbleRounded_.data(), bubbles, coefficients, bubbles, y, inside);
    weigh(numbers, modes, inside);
    for (std::size_t i = 0; i < coefficients * lanes; ++i)
      stress[i] += inside[i];
  }
  multiplyTable(liftedRounded_.data(), coefficients, tractions, coefficients, stress, forces);
}

} // namespace ndframe
