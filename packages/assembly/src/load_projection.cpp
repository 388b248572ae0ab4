#include "load_projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ndframe/assembly/point_sums.hpp"
#include "sampling_rules.hpp"

namespace ndframe
{
namespace
{

/// Of the polynomials, whose products a rule has to integrate: the highest that samples have the moments of.
constexpr int degreeIn(int dim)
{
  return 5 - dim;
}

/// Rules give the distance of functions from polynomials of this degree at least.
constexpr int degreeOfNorms = 2;

/// The first rule that integrates the polynomials' products.
const QuadratureRule& ruleOfProjections(int dim)
{
  const auto& ladder = samplingLadder(dim);
  const auto found = std::find_if(ladder.begin(), ladder.end(),
                                  [&](const SamplingRule& sampling) { return sampling.squared >= degreeIn(dim); });
  NDFRAME_ASSERT(found != ladder.end(), "a rule integrates the products of projections");
  return found->rule;
}

std::uint64_t mixed(std::uint64_t sum, std::uint64_t next)
{
  return (sum ^ next) * 0x9e3779b97f4a7c15u ^ (sum >> 29);
}

} // namespace

LoadProjection::LoadProjection(const Mesh& mesh)
    : dim_(std::size_t(mesh.dim)), basis_(MomentBasis::polynomials(mesh.dim, degreeIn(mesh.dim))),
      low_(std::size_t(MomentBasis::polynomials(mesh.dim, degreeOfNorms).size())), stamp_(stampOf(mesh)),
      rule_(ruleOfProjections(mesh.dim))
{
  atRule_ = makeTables(rule_).values;
  coefficients_.resize(paddedCount(basis_.size()) * dim_);
  factors_.resize(std::size_t(basis_.size()) * dim_);
  cells_.reserve(std::size_t(mesh.numCells()));
  values_.reserve(std::size_t(mesh.numCells()) * paddedCount(rule_.size()) * dim_);
}

std::uint64_t LoadProjection::stampOf(const Mesh& mesh)
{
  std::uint64_t sum = mixed(std::uint64_t(mesh.dim), mesh.points.size());
  for (const double coordinate : mesh.points) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    sum = mixed(sum, bits);
  }
  for (const auto* numbers : {&mesh.cells, &mesh.groups.kind})
    for (const int number : *numbers)
      sum = mixed(sum, std::uint64_t(number));
  return sum;
}

LoadProjection::Tables LoadProjection::makeTables(const QuadratureRule& rule) const
{
  const std::size_t modes = std::size_t(basis_.size()), row = paddedCount(basis_.size());
  const std::size_t points = std::size_t(rule.size()), stride = paddedCount(rule.size());
  Tables tables{std::vector<double>(points * row), std::vector<double>(modes * stride), std::vector<double>(stride)};
  std::vector<double> at(modes);
  std::copy(rule.weights.begin(), rule.weights.end(), tables.weights.begin());
  for (std::size_t g = 0; g < points; ++g) {
    basis_.values(rule.point(int(g)), at.data());
    for (std::size_t k = 0; k < modes; ++k) {
      tables.values[k * stride + g] = at[k];
      tables.weighted[g * row + k] = rule.weights[g] * at[k];
    }
  }
  return tables;
}

const LoadProjection::Tables& LoadProjection::tablesOf(const Samples& samples)
{
  if (samples.pieces.size() != 1 || samples.pieces.front().fraction != 1.0)
    return many_ = makeTables(samples.rule);
  Tables& known = known_[samples.pieces.front().rule];
  if (known.values.empty())
    known = makeTables(samples.rule);
  return known;
}

void LoadProjection::add(const LoadedSimplex& cell)
{
  const Samples& samples = cell.samples;
  isKept_ = isKept_ && samples.areCertain() && !samples.pieces.empty();
  if (!isKept_)
    return;
  const Tables& tables = tablesOf(samples);
  const std::size_t modes = std::size_t(basis_.size()), row = paddedCount(basis_.size());
  const std::size_t stride = tables.weights.size(), width = paddedCount(rule_.size());
  rowsOf(samples, int(dim_), rows_);
  combineRows(tables.weighted.data(), std::size_t(samples.rule.size()), row, rows_.data(), stride, dim_,
              coefficients_.data());
  for (std::size_t i = 0; i < dim_; ++i)
    for (std::size_t k = 0; k < modes; ++k)
      factors_[k * dim_ + i] = coefficients_[i * row + k];
  double square =
      squareOfRest(tables.values.data(), low_, stride, factors_.data(), rows_.data(), dim_, tables.weights.data());
  for (std::size_t k = low_ * dim_; k < factors_.size(); ++k)
    square -= factors_[k] * factors_[k];
  cells_.push_back({samples.scale, samples.uncertainty, samples.spread, std::sqrt(std::max(0.0, square))});
  values_.resize(values_.size() + width * dim_);
  combineRows(atRule_.data(), modes, width, coefficients_.data(), row, dim_,
              values_.data() + values_.size() - width * dim_);
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
  const std::size_t points = std::size_t(rule_.size()), width = paddedCount(rule_.size());
  const double* const rows = values_.data() + number * width * dim_;
  samples.values.resize(points * dim_);
  for (std::size_t i = 0; i < dim_; ++i)
    for (std::size_t g = 0; g < points; ++g)
      samples.values[g * dim_ + i] = rows[i * width + g];
}

} // namespace ndframe
