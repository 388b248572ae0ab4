#include "ndframe/assembly/adaptive_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "data_enclosures.hpp"
#include "data_scale.hpp"
#include "sampled_slab.hpp"
#include "sampling_rules.hpp"
#include "smooth_samples.hpp"

namespace ndframe
{
namespace
{

constexpr double negligible = 1e-14; ///< what functions may miss, times the share of the simplex where they miss it
constexpr int mostPieces = 6000;     ///< made on a simplex

/// What functions are, to be shown by their enclosures, on a slab with one of the rules.
struct Leaf
{
  SampledSlab slab;
  const QuadratureRule* rule = nullptr;
  double error = 0.0, normError = 0.0, slopeError = 0.0;
  bool isSettled = false;
  std::size_t worst = 0; ///< the function that misses most
  std::optional<AffineFunction> cut;

  double weight() const { return isSettled ? 0.0 : slab.fraction() * error; }
};

bool settlesLater(const Leaf& a, const Leaf& b)
{
  return a.weight() < b.weight();
}

/// A bound of the derivative of f minus the polynomial through the points of a rule along a piece of length 1: that of
/// f minus its Taylor polynomial, and of the polynomial through their difference by Markov's inequality. The
/// polynomials that are 1 at one Gauss point and 0 at the others add up to less than their number.
double slopeError(const Enclosure& enclosure, const SamplingRule& sampling)
{
  const double points = sampling.rule.size(), markov = 2.0 * (points - 1.0) * (points - 1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= std::min(sampling.kept + 1, Enclosure::order); ++n)
    least = std::min(least, (2.0 * n + markov * points) * enclosure.remainder[std::size_t(n)]);
  return least;
}

Leaf resolve(const SimplexGeometry& simplex, SampledSlab slab, double scale, DataEnclosures& data)
{
  const double allowed = agreementOn(simplex.dim()) * scale;
  const auto enclosures = data.on(simplex.dim(), slab.corners(simplex), slab.isWhole(), allowed);
  const double fraction = slab.fraction();
  Leaf leaf{std::move(slab), nullptr, 0.0, 0.0, 0.0, false, 0, {}};
  for (const SamplingRule& sampling : samplingLadder(simplex.dim())) {
    leaf.rule = &sampling.rule;
    leaf.error = leaf.normError = leaf.slopeError = 0.0;
    for (std::size_t f = 0; f < enclosures.size(); ++f) {
      const double error = enclosures[f].distance(sampling.kept);
      if (error > leaf.error)
        leaf.worst = f;
      leaf.error = std::max(leaf.error, error);
      leaf.normError = std::max(leaf.normError, enclosures[f].distance(sampling.squared));
      if (simplex.dim() == 1)
        leaf.slopeError = std::max(leaf.slopeError, slopeError(enclosures[f], sampling));
    }
    leaf.isSettled = (leaf.error <= allowed && leaf.normError <= agreementOfNorms * scale) ||
                     fraction * std::max(leaf.error, leaf.normError) <= negligible * scale;
    if (leaf.isSettled)
      break;
  }
  for (const auto& enclosure : enclosures)
    if (!leaf.cut)
      leaf.cut = enclosure.cut;
  return leaf;
}

std::vector<SampledSlab> split(const SimplexGeometry& simplex, const Leaf& leaf, const DataEnclosures& data)
{
  const auto across =
      leaf.cut ? leaf.cut : data.steepest(simplex.dim(), leaf.slab.corners(simplex), leaf.worst, leaf.error);
  if (across)
    if (auto slabs = leaf.slab.cut(simplex, *across); !slabs.empty())
      return slabs;
  return leaf.slab.bisect(simplex);
}

/// Adds the points of a piece, and the values of the functions there.
void append(const SimplexGeometry& geometry, const std::vector<SampledFunction>& functions, const Samples::Piece& piece,
            Samples& samples)
{
  const QuadratureRule& rule = *piece.rule;
  const auto count = std::size_t(rule.size());
  std::vector<Region::Point> points(count);
  double lambda[4];
  for (int q = 0; q < rule.size(); ++q) {
    if (piece.fraction == 1.0)
      std::copy_n(rule.point(q), geometry.dim() + 1, lambda);
    else
      geometry.locate(piece, rule.point(q), lambda);
    points[std::size_t(q)] = geometry.place(lambda);
    samples.rule.lambda.insert(samples.rule.lambda.end(), lambda, lambda + geometry.dim() + 1);
    samples.rule.weights.push_back(piece.fraction * rule.weights[std::size_t(q)]);
  }
  std::vector<double> values(count);
  samples.values.resize(samples.values.size() + count * functions.size());
  double* next = samples.values.data() + samples.values.size() - count * functions.size();
  for (std::size_t f = 0; f < functions.size(); ++f) {
    functions[f].tree->values(points.front().data(), int(count), values.data());
    for (std::size_t q = 0; q < count; ++q) {
      if (!std::isfinite(values[q]))
        functions[f].refuse(points[q].data(), geometry.space(), values[q]);
      samples.scale = std::max(samples.scale, std::abs(values[q]));
      next[q * functions.size() + f] = values[q];
    }
  }
}

Samples join(const SimplexGeometry& geometry, const std::vector<SampledFunction>& functions,
             const std::vector<Leaf>& leaves, double scale)
{
  Samples samples;
  samples.rule.dim = geometry.dim();
  samples.scale = scale;
  double mean = 0.0, square = 0.0;
  for (const Leaf& leaf : leaves)
    for (Samples::Piece piece : leaf.slab.parts()) {
      piece.rule = leaf.rule;
      piece.error = leaf.error;
      piece.normError = leaf.normError;
      piece.slopeError = leaf.slopeError;
      piece.first = samples.rule.size();
      append(geometry, functions, piece, samples);
      samples.pieces.push_back(piece);
      mean += piece.fraction * piece.error;
      square += piece.fraction * leaf.normError * leaf.normError;
    }
  samples.spread = std::sqrt(square);
  samples.uncertainty = mean == 0.0 ? 0.0 : 2.0 * mean / samples.scale; // by the rule and by the integral
  return samples;
}

} // namespace

class DataSampler::Implementation
{
public:
  Implementation(std::vector<SampledFunction> functions, int space)
      : functions_(std::move(functions)), data_(functions_, space), smooth_(functions_, space), space_(space)
  {}

  SimplexGeometry geometry(int dim, const Vertices& vertices) const { return {dim, space_, vertices}; }
  std::vector<Leaf> leaves(const SimplexGeometry& simplex, double scale);

  std::vector<SampledFunction> functions_;
  DataEnclosures data_;
  SmoothSamples smooth_;
  int space_;
  int piecesLeft_ = 200000;
};

std::vector<Leaf> DataSampler::Implementation::leaves(const SimplexGeometry& simplex, double scale)
{
  std::vector<Leaf> all{resolve(simplex, SampledSlab(simplex.whole()), scale, data_)}; // a heap, the worst on top
  int pieces = 1;
  while (all.front().weight() > 0.0 && pieces < mostPieces && piecesLeft_ > 0) {
    std::pop_heap(all.begin(), all.end(), settlesLater);
    const Leaf worst = std::move(all.back());
    all.pop_back();
    for (auto& slab : split(simplex, worst, data_)) {
      pieces += int(slab.parts().size());
      piecesLeft_ -= int(slab.parts().size());
      all.push_back(resolve(simplex, std::move(slab), scale, data_));
      std::push_heap(all.begin(), all.end(), settlesLater);
    }
  }
  return all;
}

DataSampler::DataSampler(std::vector<SampledFunction> functions, int space)
    : implementation_(std::make_unique<Implementation>(std::move(functions), space))
{}

DataSampler::~DataSampler() = default;

double DataSampler::scaleOn(const std::function<void(const Visit&)>& visit)
{
  return findScale(implementation_->functions_, implementation_->data_, implementation_->space_, visit);
}

void DataSampler::sample(int dim, const Vertices& vertices, double scale, Samples& samples)
{
  const SimplexGeometry simplex = implementation_->geometry(dim, vertices);
  if (!implementation_->smooth_.sample(simplex, scale, samples))
    samples = join(simplex, implementation_->functions_, implementation_->leaves(simplex, scale), scale);
}

int DataSampler::polynomials() const
{
  return implementation_->smooth_.polynomials();
}

void sampleConstant(int dim, const std::vector<double>& value, Samples& samples)
{
  if (samples.rule.dim != dim)
    samples.rule = simplexRule(dim, 2);
  samples.values.clear();
  samples.scale = 0.0;
  for (int q = 0; q < samples.rule.size(); ++q)
    samples.values.insert(samples.values.end(), value.begin(), value.end());
  for (const double component : value)
    samples.scale = std::max(samples.scale, std::abs(component));
}

} // namespace ndframe
