#include "load_projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ndframe/base/mixed_hash.hpp"
#include "ndframe/sampling/point_sums.hpp"
#include "ndframe/sampling/sampling_rules.hpp"

namespace ndframe
{
namespace
{

/// Rules give the distance of functions from polynomials of this degree at least.
constexpr int degreeOfNorms = 2;

} // namespace

ProjectedCells::ProjectedCells(int dim, int cells)
    : dim_(std::size_t(dim)), basis_(MomentBasis::polynomials(dim, degreeOfMoments(dim))),
      low_(std::size_t(MomentBasis::polynomials(dim, degreeOfNorms).size()))
{
  cells_.reserve(std::size_t(cells));
  coefficients_.reserve(std::size_t(cells) * std::size_t(basis_.size()) * dim_);
}

void ProjectedCells::add(const LoadedSimplex& cell)
{
  const Samples& samples = cell.samples;
  areCertain_ = areCertain_ && samples.areCertain() && !samples.pieces.empty();
  if (!areCertain_)
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

void ProjectedCells::fill(std::size_t number, LoadedSimplex& cell) const
{
  const Cell& known = cells_[number];
  cell.samples.scale = known.scale;
  cell.samples.uncertainty = known.uncertainty;
  cell.samples.spread = known.spread;
  cell.samples.rest = known.rest;
  cell.functions = basis_.size();
  cell.projection = coefficients_.data() + number * std::size_t(cell.functions) * dim_;
}

LoadProjection::LoadProjection(const Mesh& mesh, std::vector<ProjectedCells> parts)
    : stamp_(stampOf(mesh)), parts_(std::move(parts))
{}

bool LoadProjection::areCertain(const std::vector<ProjectedCells>& parts)
{
  return std::all_of(parts.begin(), parts.end(), [](const ProjectedCells& part) { return part.areCertain(); });
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

void LoadProjection::fill(std::size_t number, LoadedSimplex& cell) const
{
  const std::size_t size = parts_.front().size();
  parts_[number / size].fill(number % size, cell);
}

} // namespace ndframe
