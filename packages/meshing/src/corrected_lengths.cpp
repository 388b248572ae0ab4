#include "corrected_lengths.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

constexpr double mostCorrection = 2.0; ///< of log2 of a measure, at once

double at(const LengthField& lengths, const Mesh& mesh, int vertex)
{
  const double* x = mesh.point(vertex);
  return lengths.at({x[0], x[1], x[2]});
}

} // namespace

WantedMesh correctedLengths(const LengthField& wanted, const LengthField& given, const Mesh& made)
{
  std::vector<double> sums(std::size_t(made.numPoints()), 0.0); // of log2 of measures by the wanted ones
  std::vector<int> cells(sums.size(), 0);
  for (int c = 0; c < made.numCells(); ++c) {
    const double regular = std::pow(wanted.at(cellCentre(made, c)), 3) / std::sqrt(72.0);
    for (int k = 0; k < 4; ++k) {
      sums[std::size_t(made.cell(c)[k])] += std::log2(cellMeasure(made, c) / regular);
      ++cells[std::size_t(made.cell(c)[k])];
    }
  }
  WantedMesh corrected{made, {}};
  for (int v = 0; v < made.numPoints(); ++v) {
    const double mean = sums[std::size_t(v)] / cells[std::size_t(v)];
    corrected.lengths.push_back(at(given, made, v) *
                                std::exp2(-std::clamp(mean, -mostCorrection, mostCorrection) / 3.0));
  }
  return corrected;
}

} // namespace ndframe
