#include "ndframe/assembly/adaptive_samples.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"
#include "sampling_rules.hpp"

namespace ndframe
{
namespace
{

constexpr double agreement = 1e-12;           ///< of a function with its polynomials, relative to its scale
constexpr int mostPieces[] = {0, 128, 64, 4}; ///< by dimension: pieces of higher dimension hold more points

/// A piece with the values at the points of its rule and what polynomials miss of them, weighted with the piece.
struct Leaf
{
  Samples::Piece piece;
  std::vector<double> values;
  double error = 0.0;
};

/// The function to be sampled and the simplex it is sampled on.
class Sampler
{
public:
  Sampler(int dim, const double* const* vertices, int space, int components, double scale, const PointFunction& f)
      : dim_(dim), space_(space), components_(components), vertices_(vertices), f_(f), scale_(scale)
  {}

  /// Climbs the ladder on a piece until a rule settles.
  Leaf resolve(const Samples::Piece& piece)
  {
    Leaf leaf{piece, {}, 0.0};
    for (const SamplingRule& sampling : samplingLadder(dim_)) {
      leaf.piece.rule = &sampling.rule;
      leaf.values.clear();
      evaluate(piece, sampling.rule.lambda, leaf.values);
      for (const double value : leaf.values)
        scale_ = std::max(scale_, std::abs(value));
      const std::size_t size = leaf.values.size();
      evaluate(piece, sampling.corners, leaf.values);
      leaf.error = piece.fraction * largestRest(sampling.rest, leaf.values);
      leaf.values.resize(size);
      if (settled(leaf))
        break;
    }
    return leaf;
  }

  bool settled(const Leaf& leaf) const { return leaf.error <= agreement * scale_; }
  double scale() const { return scale_; }

  /// Barycentric coordinates in the simplex of a rule's point on a piece.
  void locate(const Samples::Piece& piece, const double* local, double* lambda) const
  {
    for (int k = 0; k <= dim_; ++k) {
      lambda[k] = 0.0;
      for (int corner = 0; corner <= dim_; ++corner)
        lambda[k] += local[corner] * piece.corners[std::size_t(corner * (dim_ + 1) + k)];
    }
  }

  /// Halves the longest edge of a piece.
  std::array<Samples::Piece, 2> bisect(const Samples::Piece& piece) const;

private:
  void evaluate(const Samples::Piece& piece, const std::vector<double>& points, std::vector<double>& values) const;
  double largestRest(const DenseMatrix& rest, const std::vector<double>& values) const;
  void place(const double* lambda, double* x) const;

  int dim_, space_, components_;
  const double* const* vertices_;
  const PointFunction& f_;
  double scale_;
};

void Sampler::place(const double* lambda, double* x) const
{
  std::fill_n(x, space_, 0.0);
  for (int v = 0; v <= dim_; ++v)
    for (int k = 0; k < space_; ++k)
      x[k] += lambda[v] * vertices_[v][k];
}

/// Appends the values at points, barycentric in the piece.
void Sampler::evaluate(const Samples::Piece& piece, const std::vector<double>& points,
                       std::vector<double>& values) const
{
  std::size_t next = values.size();
  values.resize(next + points.size() / std::size_t(dim_ + 1) * std::size_t(components_));
  double lambda[4], x[3] = {};
  for (std::size_t q = 0; q < points.size(); q += std::size_t(dim_ + 1)) {
    locate(piece, points.data() + q, lambda);
    place(lambda, x);
    f_(x, values.data() + next);
    for (const std::size_t end = next + std::size_t(components_); next < end; ++next)
      NDFRAME_ASSERT(std::isfinite(values[next]), "functions refuse values that are not finite themselves");
  }
}

double Sampler::largestRest(const DenseMatrix& rest, const std::vector<double>& values) const
{
  double largest = 0.0;
  std::vector<double> sums(std::size_t(rest.rows()));
  for (int k = 0; k < components_; ++k) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int q = 0; q < rest.cols(); ++q)
      for (int i = 0; i < rest.rows(); ++i)
        sums[std::size_t(i)] += rest(i, q) * values[std::size_t(q * components_ + k)];
    for (const double sum : sums)
      largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

std::array<Samples::Piece, 2> Sampler::bisect(const Samples::Piece& piece) const
{
  int first = 0, second = 1;
  double longest = -1.0, x[4][3];
  const double* corners = piece.corners.data();
  for (int a = 0; a <= dim_; ++a)
    place(corners + a * (dim_ + 1), x[a]);
  for (int a = 0; a <= dim_; ++a)
    for (int b = a + 1; b <= dim_; ++b) {
      double square = 0.0;
      for (int k = 0; k < space_; ++k)
        square += (x[a][k] - x[b][k]) * (x[a][k] - x[b][k]);
      if (square > longest)
        longest = square, first = a, second = b;
    }
  std::array<Samples::Piece, 2> halves{piece, piece};
  for (int k = 0; k <= dim_; ++k) {
    const double middle = 0.5 * (corners[first * (dim_ + 1) + k] + corners[second * (dim_ + 1) + k]);
    halves[0].corners[std::size_t(second * (dim_ + 1) + k)] = middle;
    halves[1].corners[std::size_t(first * (dim_ + 1) + k)] = middle;
  }
  halves[0].fraction = halves[1].fraction = 0.5 * piece.fraction;
  return halves;
}

Samples::Piece wholeSimplex(int dim)
{
  Samples::Piece piece;
  for (int corner = 0; corner <= dim; ++corner)
    piece.corners[std::size_t(corner * (dim + 2))] = 1.0;
  return piece;
}

Samples join(const Sampler& sampler, int dim, const std::vector<Leaf>& leaves)
{
  Samples samples;
  samples.rule.dim = dim;
  samples.scale = sampler.scale();
  double lambda[4];
  for (const Leaf& leaf : leaves) {
    samples.pieces.push_back(leaf.piece);
    samples.pieces.back().first = samples.rule.size();
    for (int q = 0; q < leaf.piece.rule->size(); ++q) {
      sampler.locate(leaf.piece, leaf.piece.rule->point(q), lambda);
      samples.rule.lambda.insert(samples.rule.lambda.end(), lambda, lambda + dim + 1);
      samples.rule.weights.push_back(leaf.piece.fraction * leaf.piece.rule->weights[std::size_t(q)]);
    }
    samples.values.insert(samples.values.end(), leaf.values.begin(), leaf.values.end());
    if (!sampler.settled(leaf))
      samples.uncertainty += leaf.error / sampler.scale();
  }
  return samples;
}

} // namespace

Samples sampleAdaptively(int dim, const double* const* vertices, int space, int components, double scale,
                         const PointFunction& f)
{
  Sampler sampler(dim, vertices, space, components, scale, f);
  const auto settlesLater = [](const Leaf& a, const Leaf& b) { return a.error < b.error; };
  std::vector<Leaf> leaves{sampler.resolve(wholeSimplex(dim))}; // a heap, the worst leaf on top
  while (!sampler.settled(leaves.front()) && int(leaves.size()) < mostPieces[dim]) {
    const auto halves = sampler.bisect(leaves.front().piece);
    std::pop_heap(leaves.begin(), leaves.end(), settlesLater);
    leaves.pop_back();
    for (const auto& half : halves) {
      leaves.push_back(sampler.resolve(half));
      std::push_heap(leaves.begin(), leaves.end(), settlesLater);
    }
  }
  return join(sampler, dim, leaves);
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
