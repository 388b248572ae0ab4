#include "smooth_samples.hpp"

#include <cmath>
#include <limits>

#include "ndframe/sampling/sampling_rules.hpp"

namespace ndframe
{
namespace
{

int degreeOf(const SampledFunction& function)
{
  return function.tree->root().degree;
}

/// What a value of an expression costs, about, in terms of a polynomial.
double termsOf(const ExpressionTree& tree)
{
  double terms = 0.0;
  for (const ExpressionNode& node : tree.nodes())
    terms += node.operation == Operation::Power || node.operation >= Operation::Sin ? 300.0 : 30.0;
  return terms;
}

/// By 3 % at most, so that neighbours have the same.
double roundedUp(double radius)
{
  int exponent = 0;
  const double mantissa = std::frexp(radius, &exponent);
  return std::ldexp(std::ceil(64.0 * mantissa) / 64.0, exponent);
}

/// Makes samples of one piece that takes up the simplex, by a rule; most often they are that already.
void beginWhole(const SimplexGeometry& simplex, const QuadratureRule& rule, Samples& samples)
{
  if (samples.pieces.size() != 1 || samples.pieces.front().rule != &rule || samples.pieces.front().fraction != 1.0) {
    samples.pieces.assign(1, simplex.whole());
    samples.pieces.front().rule = &rule;
    samples.rule = rule;
  }
}

} // namespace

SmoothSamples::SmoothSamples(const std::vector<SampledFunction>& functions, int space)
    : functions_(functions),
      arePolynomials_(std::all_of(functions.begin(), functions.end(), [](const auto& f) { return degreeOf(f) >= 0; })),
      here_(functions.size()), cells_(functions.size()), chosen_(functions.size())
{
  ofPolynomials_.reserve(functions.size());
  for (const auto& function : functions) {
    boxes_.emplace_back(*function.tree, space);
    terms_.push_back(termsOf(*function.tree));
    ofPolynomials_.emplace_back();
    for (int m = 0; m < degreeOf(function) && m <= highestKeptWhole; ++m)
      ofPolynomials_.back()[std::size_t(m)] = std::numeric_limits<double>::infinity();
    distances_.push_back(&ofPolynomials_.back());
  }
}

void SmoothSamples::begin(double scale)
{
  for (auto& boxes : boxes_)
    boxes.begin(scale == scale_);
  scale_ = scale;
}

int SmoothSamples::polynomials() const
{
  int sum = 0;
  for (const auto& boxes : boxes_)
    sum += boxes.fitted();
  return sum;
}

bool SmoothSamples::findPolynomials(const Place& place, double allowed)
{
  for (std::size_t f = 0; f < functions_.size(); ++f)
    if (degreeOf(functions_[f]) < 0) {
      here_[f] = boxes_[f].around(place.centroid, place.radius, allowed);
      if (here_[f] == nullptr)
        return false;
      distances_[f] = &here_[f]->distances(place.radius);
      chosen_[f] = &here_[f]->polynomial();
    }
  return true;
}

void SmoothSamples::recentre(const Place& place, double leftOut)
{
  for (std::size_t f = 0; f < functions_.size(); ++f)
    if (here_[f] != nullptr) {
      cells_[f].recentre(*here_[f], place.centroid, place.radius, leftOut);
      distances_[f] = &cells_[f].distances();
      chosen_[f] = &cells_[f].polynomial();
    }
}

/// What the functions miss of polynomials.
double SmoothSamples::distance(int degree) const
{
  double largest = 0.0;
  for (const auto* distances : distances_)
    largest = std::max(largest, (*distances)[std::size_t(degree)]);
  return largest;
}

/// The one of fewest points that serves all functions; null: none does.
const SamplingRule* SmoothSamples::findRule(const SimplexGeometry& simplex, double scale) const
{
  const int dim = simplex.dim();
  const double oscillation = distance(degreeOfMoments(dim)); // infinite for polynomials of a higher degree
  const bool isLoadOfCell = dim == simplex.space() && std::isfinite(oscillation);
  const double ofMeans = agreementOfSmoothMeans(dim) * scale,
               ofNorms =
                   std::max(agreementOfSmoothNorms(dim) * scale, isLoadOfCell ? shareOfOscillation * oscillation : 0.0);
  for (const SamplingRule& sampling : smoothLadder(dim))
    if (distance(sampling.kept) <= ofMeans && distance(sampling.squared) <= ofNorms)
      return &sampling;
  return nullptr;
}

bool SmoothSamples::sample(const SimplexGeometry& simplex, double scale, Samples& samples)
{
  constexpr double share = 0.5, shareOfPowers = 0.1; // of what a function may miss: the box's, of powers left out
  constexpr int many = 100;                          // points, where it pays to write the polynomials about the cell
  const double allowed = agreementOfSmoothMeans(simplex.dim()) * scale;
  Place place;
  if (!arePolynomials_) {
    if (simplex.dim() == 1)
      return false;
    simplex.extent(place.centroid, place.radius);
    place.radius = roundedUp(place.radius);
    if (!findPolynomials(place, share * allowed))
      return false;
  }
  const SamplingRule* sampling = findRule(simplex, scale);
  if (!arePolynomials_ && (sampling == nullptr || sampling->rule.size() > many)) {
    recentre(place, shareOfPowers * allowed);
    sampling = findRule(simplex, scale);
  }
  if (sampling == nullptr)
    return false;
  const double error = distance(sampling->kept);
  beginWhole(simplex, sampling->rule, samples);
  samples.pieces.front().error = error;
  samples.pieces.front().normError = samples.spread = distance(sampling->squared);
  samples.scale = scale;
  samples.uncertainty = error == 0.0 ? 0.0 : 2.0 * error / scale;
  addValues(simplex, *sampling, samples);
  return true;
}

void SmoothSamples::addValues(const SimplexGeometry& simplex, const SamplingRule& sampling, Samples& samples)
{
  const std::size_t count = std::size_t(samples.rule.size()), size = functions_.size();
  values_.resize(std::max(count, sampling.padded.size() / std::size_t(simplex.dim() + 1)));
  samples.values.resize(count * size);
  for (std::size_t f = 0; f < size; ++f) {
    if (chosen_[f] != nullptr && double(chosen_[f]->numTerms()) <= terms_[f])
      chosen_[f]->values(simplex.vertices(), sampling, values_.data());
    else
      evaluate(functions_[f], simplex, samples);
    for (std::size_t q = 0; q < count; ++q)
      samples.values[q * size + f] = values_[q];
  }
}

/// The values of a polynomial, which may be too large for a number.
void SmoothSamples::evaluate(const SampledFunction& function, const SimplexGeometry& simplex, Samples& samples)
{
  if (function.tree->isConstant() && std::isfinite(function.tree->root().constant)) {
    std::fill(values_.begin(), values_.end(), function.tree->root().constant);
    samples.scale = std::max(samples.scale, std::abs(values_.front()));
    return;
  }
  const std::size_t count = std::size_t(samples.rule.size());
  points_.resize(3 * count);
  simplex.place(samples.rule, points_.data());
  function.tree->values(points_.data(), int(count), values_.data());
  for (std::size_t q = 0; q < count; ++q) {
    if (!std::isfinite(values_[q]))
      function.refuse(&points_[3 * q], simplex.space(), values_[q]);
    samples.scale = std::max(samples.scale, std::abs(values_[q]));
  }
}

} // namespace ndframe
