#include "load_projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ndframe/assembly/point_sums.hpp"
#include "ndframe/base/mixed_hash.hpp"
#include "sampling_rules.hpp"

namespace ndframe
{
namespace
{

/// Rules give the distance of functions from polynomials of this degree at least.
constexpr int degreeOfNorms = 2;

} // namespace

LoadProjection::LoadProjection(const Mesh& mesh)
    : dim_(std::size_t(mesh.dim)), basis_(MomentBasis::polynomials(mesh.dim, degreeOfMoments(mesh.dim))),
      low_(std::size_t(MomentBasis::polynomials(mesh.dim, degreeOfNorms).size())), stamp_(stampOf(mesh))
{
  cells_.reserve(std::size_t(mesh.numCells()));
  coefficients_.reserve(std::size_t(mesh.numCells()) * std::size_t(basis_.size()) * dim_);
}

std::uint64_t LoadProjection::stampOf(const Mesh& mesh)
{
  std::uint64_t sum = mixedHash(std::uint64_t(mesh.dim), mesh.points.size());
  for (const double coordinate : mesh.points) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    sum = mixedHash(sum, bits);
  }
  for (const auto* numbers : {&mesh.cells, &mesh.groups.kind})
    for (const int number : *numbers)
      sum = mixedHash(sum, std::uint64_t(number));
  return sum;
}

void LoadProjection::add(const LoadedSimplex& cell)
{
  const Samples& samples = cell.samples;
  isKept_ = isKept_ && samples.areCertain() && !samples.pieces.empty();
  if (!isKept_)
    return;
  const BasisTables& tables = basis_.at(samples, ascendingPlaces(cell));
  const std::size_t count = std::size_t(basis_.size()) * dim_;
  coefficients_.resize(coefficients_.size() + count);
  double* const coefficients = coefficients_.data() + coefficients_.size() - count;
  sumOverPoints(tables.weighted.data(), samples.rule.size(), basis_.size(), 1.0, samples.values.data(), dim_,
                coefficients);
  rowsOf(samples, int(dim_), rows_);
  double square = squareOfRest(tables.values.data(), low_, tables.weights.size(), coefficients, rows_.data(), dim_,
                               tables.weights.data());
  for (std::size_t k = low_ * dim_; k < count; ++k)
    square -= coefficients[k] * coefficients[k];
  cells_.push_back({samples.scale, samples.uncertainty, samples.spread, std::sqrt(std::max(0.0, square))});
}

void LoadProjection::fill(std::size_t number, LoadedSimplex& cell) const
{
  const Cell& known = cells_[number];
  cell.samples.scale = known.scale;
  cell.samples.uncertainty = known.uncertainty;
  cell.samples.spread = known.spread;
  cell.samples.rest = known.rest;
  cell.functions = basis_.size();
  cell.projection = coefficients_.data() + number * std::size_t(cell.functions) * dim_;
}

} // namespace ndframe
