#include "ndframe/sampling/adaptive_samples.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "data_scale.hpp"
#include "sampled_leaf.hpp"
#include "smooth_samples.hpp"

namespace ndframe
{
namespace
{

constexpr int mostPieces = 6000;        ///< made on a simplex
constexpr int mostPiecesInAll = 200000; ///< on those of a call of scaleOn

bool settlesLater(const SampledLeaf& a, const SampledLeaf& b)
{
  return a.weight() < b.weight();
}

/// The points of a piece's rule in the simplex.
QuadratureRule locate(const SimplexGeometry& geometry, const Samples::Piece& piece)
{
  QuadratureRule located = *piece.rule;
  if (piece.fraction == 1.0)
    return located;
  for (int q = 0; q < located.size(); ++q) {
    geometry.locate(piece, piece.rule->point(q), located.lambda.data() + std::ptrdiff_t(q) * (geometry.dim() + 1));
    located.weights[std::size_t(q)] *= piece.fraction;
  }
  return located;
}

/// Adds the points of a rule in the simplex, and the values of the functions there.
void append(const SimplexGeometry& geometry, const std::vector<SampledFunction>& functions, const QuadratureRule& rule,
            Samples& samples)
{
  const auto count = std::size_t(rule.size());
  std::vector<Region::Point> points(count);
  for (int q = 0; q < rule.size(); ++q)
    points[std::size_t(q)] = geometry.place(rule.point(q));
  samples.rule.lambda.insert(samples.rule.lambda.end(), rule.lambda.begin(), rule.lambda.end());
  samples.rule.weights.insert(samples.rule.weights.end(), rule.weights.begin(), rule.weights.end());
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

/// Adds the pieces of a leaf with their points.
void append(const SimplexGeometry& geometry, const std::vector<SampledFunction>& functions, const SampledLeaf& leaf,
            Samples& samples)
{
  const auto add = [&](Samples::Piece piece, const QuadratureRule& located) {
    piece.error = leaf.error;
    piece.normError = leaf.normError;
    piece.slopeError = leaf.slopeError;
    piece.first = samples.rule.size();
    append(geometry, functions, located, samples);
    samples.pieces.push_back(piece);
  };
  for (const QuadratureRule& side : leaf.sides) {
    Samples::Piece piece = leaf.slab.parts().front();
    piece.fraction = std::accumulate(side.weights.begin(), side.weights.end(), 0.0);
    add(piece, side);
  }
  if (!leaf.sides.empty())
    return;
  for (Samples::Piece piece : leaf.slab.parts()) {
    piece.rule = &leaf.sampling->rule;
    add(piece, locate(geometry, piece));
  }
}

Samples join(const SimplexGeometry& geometry, const std::vector<SampledFunction>& functions,
             const std::vector<SampledLeaf>& leaves, double scale)
{
  Samples samples;
  samples.rule.dim = geometry.dim();
  samples.scale = scale;
  double mean = 0.0, square = 0.0;
  for (const SampledLeaf& leaf : leaves) {
    append(geometry, functions, leaf, samples);
    mean += leaf.slab.fraction() * leaf.error + leaf.openError;
    square += leaf.slab.fraction() * leaf.normError * leaf.normError + leaf.openSquare;
  }
  samples.spread = std::sqrt(square);
  samples.uncertainty = mean == 0.0 ? 0.0 : 2.0 * mean / samples.scale; // by the rule and by the integral
  return samples;
}

} // namespace

class DataSampler::Implementation
{
public:
  Implementation(std::vector<SampledFunction> functions, int space, Cuts cuts)
      : functions_(std::move(functions)), data_(functions_, space), smooth_(functions_, space), space_(space),
        cuts_(cuts)
  {}

  SimplexGeometry geometry(int dim, const Vertices& vertices) const { return {dim, space_, vertices}; }
  std::vector<SampledLeaf> leaves(const SimplexGeometry& simplex, double scale);
  std::vector<SampledSlab> refine(const SimplexGeometry& simplex, const SampledLeaf& leaf, double scale,
                                  std::vector<SampledLeaf>& done) const;

  std::vector<SampledFunction> functions_;
  DataEnclosures data_;
  SmoothSamples smooth_;
  int space_;
  Cuts cuts_;
  int piecesLeft_ = mostPiecesInAll;
};

/// A leaf that is settled along a curve goes to `done`; otherwise the slabs that take the leaf's place.
std::vector<SampledSlab> DataSampler::Implementation::refine(const SimplexGeometry& simplex, const SampledLeaf& leaf,
                                                             double scale, std::vector<SampledLeaf>& done) const
{
  if (cuts_ == Cuts::Curved && simplex.dim() == 2 && leaf.switchesAlongCurve()) {
    if (leaf.slab.parts().size() > 1)
      return leaf.slab.bisect(simplex);
    if (auto settled = settledOnSides(simplex, leaf, scale, data_)) {
      if (!settled->areSidesFound)
        return leaf.slab.bisect(simplex);
      done.push_back(std::move(*settled));
      return {};
    }
  }
  return split(simplex, leaf, data_);
}

std::vector<SampledLeaf> DataSampler::Implementation::leaves(const SimplexGeometry& simplex, double scale)
{
  std::vector<SampledLeaf> all{
      resolve(simplex, SampledSlab(simplex.whole()), scale, data_)}; // a heap, the worst on top
  std::vector<SampledLeaf> done;
  int pieces = 1;
  while (!all.empty() && all.front().weight() > 0.0 && pieces < mostPieces && piecesLeft_ > 0) {
    std::pop_heap(all.begin(), all.end(), settlesLater);
    const SampledLeaf worst = std::move(all.back());
    all.pop_back();
    for (auto& slab : refine(simplex, worst, scale, done)) {
      pieces += int(slab.parts().size());
      piecesLeft_ -= int(slab.parts().size());
      all.push_back(resolve(simplex, std::move(slab), scale, data_));
      std::push_heap(all.begin(), all.end(), settlesLater);
    }
  }
  all.insert(all.end(), std::make_move_iterator(done.begin()), std::make_move_iterator(done.end()));
  return all;
}

DataSampler::DataSampler(std::vector<SampledFunction> functions, int space, Cuts cuts)
    : implementation_(std::make_unique<Implementation>(std::move(functions), space, cuts))
{}

DataSampler::~DataSampler() = default;

double DataSampler::scaleOn(const std::function<void(const Visit&)>& visit)
{
  implementation_->piecesLeft_ = mostPiecesInAll;
  const double scale = findScale(implementation_->functions_, implementation_->data_, implementation_->space_, visit);
  implementation_->smooth_.begin(scale);
  return scale;
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
