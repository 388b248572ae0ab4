#include "ndframe/assembly/adaptive_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "data_enclosures.hpp"
#include "sampled_slab.hpp"
#include "sampling_rules.hpp"

namespace ndframe
{
namespace
{

constexpr double agreement = 1e-13;  ///< what functions may miss of polynomials, relative to their scale
constexpr double negligible = 1e-14; ///< the same, times the share of the simplex where they miss it
constexpr int mostPieces = 6000;     ///< made on a simplex
constexpr int mostSearched = 4000;   ///< pieces looked at for the largest value

/// The largest absolute value of the functions at a point, 0 where it is not finite.
double sizeAt(const std::vector<SampledFunction>& functions, const Region::Point& x)
{
  double size = 0.0, value = 0.0;
  for (const auto& function : functions) {
    function.tree->values(x.data(), 1, &value);
    if (std::isfinite(value))
      size = std::max(size, std::abs(value));
  }
  return size;
}

/// Widens a box, by its corners, to a point.
void widen(std::vector<Region::Point>& corners, const double* x, int space)
{
  if (corners.empty()) {
    Region::Point first{};
    std::copy_n(x, space, first.begin());
    corners.assign(std::size_t(1) << space, first);
  }
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    for (std::size_t k = 0; k < std::size_t(space); ++k)
      corners[corner][k] =
          (corner >> k) % 2 == 0 ? std::min(corners[corner][k], x[k]) : std::max(corners[corner][k], x[k]);
}

/// What functions are, to be shown by their enclosures, on a slab with one of the rules.
struct Leaf
{
  SampledSlab slab;
  const QuadratureRule* rule = nullptr;
  double error = 0.0, slopeError = 0.0;
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
  const auto enclosures = data.on(simplex.dim(), slab.corners(simplex), slab.isWhole(), agreement * scale);
  const double fraction = slab.fraction();
  Leaf leaf{std::move(slab), nullptr, 0.0, 0.0, false, 0, {}};
  for (const SamplingRule& sampling : samplingLadder(simplex.dim())) {
    leaf.rule = &sampling.rule;
    leaf.error = leaf.slopeError = 0.0;
    for (std::size_t f = 0; f < enclosures.size(); ++f) {
      const double error = enclosures[f].distance(sampling.kept);
      if (error > leaf.error)
        leaf.worst = f;
      leaf.error = std::max(leaf.error, error);
      if (simplex.dim() == 1)
        leaf.slopeError = std::max(leaf.slopeError, slopeError(enclosures[f], sampling));
    }
    leaf.isSettled = leaf.error <= agreement * scale || fraction * leaf.error <= negligible * scale;
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
      piece.slopeError = leaf.slopeError;
      piece.first = samples.rule.size();
      append(geometry, functions, piece, samples);
      samples.pieces.push_back(piece);
      mean += piece.fraction * piece.error;
      square += piece.fraction * piece.error * piece.error;
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
      : functions_(std::move(functions)), data_(functions_, space), space_(space)
  {}

  SimplexGeometry geometry(int dim, const Vertices& vertices) const { return {dim, space_, vertices}; }
  double scaleOn(const std::function<void(const Visit&)>& visit);
  double searched(std::vector<std::pair<SimplexGeometry, Samples::Piece>> candidates, double found);
  std::vector<Leaf> leaves(const SimplexGeometry& simplex, double scale);

  std::vector<SampledFunction> functions_;
  DataEnclosures data_;
  int space_;
  int piecesLeft_ = 200000;
};

double DataSampler::Implementation::scaleOn(const std::function<void(const Visit&)>& visit)
{
  double found = 0.0;
  const auto centroid = [](const SimplexGeometry& simplex) {
    const double share = 1.0 / (simplex.dim() + 1), lambda[4] = {share, share, share, share};
    return simplex.place(lambda);
  };
  std::vector<Region::Point> corners; // of the box around all
  visit([&](int dim, const Vertices& vertices) {
    const Region::Point x = centroid(geometry(dim, vertices));
    found = std::max(found, sizeAt(functions_, x));
    for (int v = 0; v <= dim; ++v)
      widen(corners, vertices[std::size_t(v)], space_);
  });
  std::vector<std::pair<SimplexGeometry, Samples::Piece>> candidates;
  if (!data_.arePolynomials() && data_.largestBetween(corners) > 2.0 * found)
    visit([&](int dim, const Vertices& vertices) {
      const SimplexGeometry simplex = geometry(dim, vertices);
      if (data_.largestAround(simplex) > 2.0 * found)
        candidates.emplace_back(simplex, simplex.whole());
    });
  return searched(std::move(candidates), found);
}

/// Branch and bound: the piece with the largest bound is split until no bound is above twice the largest value found.
double DataSampler::Implementation::searched(std::vector<std::pair<SimplexGeometry, Samples::Piece>> candidates,
                                             double found)
{
  using Entry = std::pair<double, std::size_t>;
  std::vector<Entry> open;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    open.emplace_back(data_.largestBetween(candidates[i].first.corners(candidates[i].second)), i);
  std::make_heap(open.begin(), open.end());
  for (int step = 0; step < mostSearched && !open.empty() && open.front().first > 2.0 * found; ++step) {
    std::pop_heap(open.begin(), open.end());
    const auto [simplex, piece] = candidates[open.back().second];
    open.pop_back();
    for (const auto& half : simplex.bisect(piece)) {
      Region::Point middle{};
      for (const auto& corner : simplex.corners(half))
        for (std::size_t k = 0; k < 3; ++k)
          middle[k] += corner[k] / (simplex.dim() + 1);
      found = std::max(found, sizeAt(functions_, middle));
      candidates.emplace_back(simplex, half);
      open.emplace_back(data_.largestBetween(simplex.corners(half)), candidates.size() - 1);
      std::push_heap(open.begin(), open.end());
    }
  }
  return found;
}

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
  return implementation_->scaleOn(visit);
}

Samples DataSampler::sample(int dim, const Vertices& vertices, double scale)
{
  const SimplexGeometry simplex = implementation_->geometry(dim, vertices);
  return join(simplex, implementation_->functions_, implementation_->leaves(simplex, scale), scale);
}

Samples sampleConstant(int dim, const std::vector<double>& value)
{
  Samples samples;
  samples.rule = simplexRule(dim, 2);
  for (int q = 0; q < samples.rule.size(); ++q)
    samples.values.insert(samples.values.end(), value.begin(), value.end());
  for (const double component : value)
    samples.scale = std::max(samples.scale, std::abs(component));
  return samples;
}

} // namespace ndframe
