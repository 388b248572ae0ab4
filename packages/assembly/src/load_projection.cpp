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

/// The first rule that integrates the polynomials' products.
const QuadratureRule& ruleOfProjections(int dim)
{
  const auto& ladder = samplingLadder(dim);
  const auto found = std::find_if(ladder.begin(), ladder.end(), [&](const SamplingRule& sampling) {
    return sampling.squared >= degreeOfMoments(dim);
  });
  NDFRAME_ASSERT(found != ladder.end(), "a rule integrates the products of projections");
  return found->rule;
}

} // namespace

LoadProjection::LoadProjection(const Mesh& mesh)
    : dim_(std::size_t(mesh.dim)), basis_(MomentBasis::polynomials(mesh.dim, degreeOfMoments(mesh.dim))),
      low_(std::size_t(MomentBasis::polynomials(mesh.dim, degreeOfNorms).size())), stamp_(stampOf(mesh)),
      rule_(ruleOfProjections(mesh.dim))
{
  atRule_ = basis_.at(rule_).values;
  factors_.resize(std::size_t(basis_.size()) * dim_);
  cells_.reserve(std::size_t(mesh.numCells()));
  values_.reserve(std::size_t(mesh.numCells()) * std::size_t(rule_.size()) * dim_);
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
  const BasisTables& tables = basis_.at(samples);
  sumOverPoints(tables.weighted.data(), samples.rule.size(), basis_.size(), 1.0, samples.values.data(), dim_,
                factors_.data());
  rowsOf(samples, int(dim_), rows_);
  double square = squareOfRest(tables.values.data(), low_, tables.weights.size(), factors_.data(), rows_.data(), dim_,
                               tables.weights.data());
  for (std::size_t k = low_ * dim_; k < factors_.size(); ++k)
    square -= factors_[k] * factors_[k];
  cells_.push_back({samples.scale, samples.uncertainty, samples.spread, std::sqrt(std::max(0.0, square))});
  const std::size_t count = std::size_t(rule_.size()) * dim_;
  values_.resize(values_.size() + count);
  sumOverPoints(atRule_.data(), basis_.size(), rule_.size(), 1.0, factors_.data(), dim_,
                values_.data() + values_.size() - count);
}

void LoadProjection::fill(std::size_t number, Samples& samples) const
{
  if (samples.pieces.size() != 1 || samples.pieces.front().rule != &rule_) {
    samples.rule = rule_;
    samples.pieces.assign(1, {});
    Samples::Piece& whole = samples.pieces.front();
    whole.rule = &rule_;
    for (std::size_t v = 0; v <= dim_; ++v)
      whole.corners[v * (dim_ + 1) + v] = 1.0;
  }
  const Cell& cell = cells_[number];
  samples.scale = cell.scale;
  samples.uncertainty = cell.uncertainty;
  samples.spread = cell.spread;
  samples.rest = cell.rest;
  const std::size_t count = std::size_t(rule_.size()) * dim_;
  const double* const first = values_.data() + number * count;
  samples.values.assign(first, first + count);
}

} // namespace ndframe
