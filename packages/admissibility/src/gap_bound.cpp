#include "ndframe/admissibility/gap_bound.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "doubt.hpp"
#include "edge_pieces.hpp"

namespace ndframe
{
namespace
{

/// A gap that differs from its interpolant by less, relative to its size, is the interpolant.
constexpr double roundOff = 1e-12;

/// Bernstein coefficients of the interpolant at the nodes, from the values at the vertices and (order 2) in the middle.
Vector interpolant(int order, const std::array<double, 3>& atNodes)
{
  if (order == 1)
    return {atNodes[0], atNodes[1]};
  return {atNodes[0], 2.0 * atNodes[2] - 0.5 * (atNodes[0] + atNodes[1]), atNodes[1]};
}

double valueAt(const Vector& bernstein, double t)
{
  const double s = 1.0 - t;
  if (bernstein.size() == 2)
    return s * bernstein[0] + t * bernstein[1];
  return s * s * bernstein[0] + 2.0 * s * t * bernstein[1] + t * t * bernstein[2];
}

/// The interpolant minus the gap on a facet, on every piece a polynomial and an error.
class Excess
{
public:
  Excess(const Vector& bernstein, const Samples& gap, EdgePieces& pieces) : gap_(gap), pieces_(pieces)
  {
    for (int i = 0; i < gap.rule.size(); ++i)
      values_.push_back(valueAt(bernstein, gap.rule.point(i)[1]) - gap.values[std::size_t(i)]);
  }

  bool isRoundOff() const
  {
    const auto isSmall = [this](double value) { return std::abs(value) <= roundOff * gap_.scale; };
    return std::all_of(values_.begin(), values_.end(), isSmall) &&
           std::all_of(gap_.pieces.begin(), gap_.pieces.end(), [&](const auto& piece) { return isSmall(piece.error); });
  }

  /// An upper bound of what is left of it less kappa t (1 - t), 0 when that is nowhere positive but for round-off.
  double left(double kappa) const
  {
    Vector rest = values_;
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] -= kappa * gap_.rule.point(int(i))[0] * gap_.rule.point(int(i))[1];
    double largest = 0.0;
    for (const auto& piece : gap_.pieces)
      largest = std::max(largest, pieces_.upperBound(*piece.rule, rest.data() + piece.first) +
                                      EdgePieces::interpolationFactor(*piece.rule) * piece.error);
    return largest <= roundOff * gap_.scale ? 0.0 : largest;
  }

  /// About the smallest kappa that leaves no more than a very large one.
  double bubble() const
  {
    constexpr double veryLarge = 1024.0;
    constexpr int halvings = 20;
    double least = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i)
      least = std::max(least, values_[i] / (gap_.rule.point(int(i))[0] * gap_.rule.point(int(i))[1]));
    double enough = veryLarge * least;
    const double unavoidable = (1.0 + 1e-6) * left(enough);
    for (int step = 0; step < halvings; ++step)
      (left(0.5 * (least + enough)) <= unavoidable ? enough : least) = 0.5 * (least + enough);
    return enough;
  }

private:
  const Samples& gap_;
  EdgePieces& pieces_;
  Vector values_;
};

/// Lowers the interpolant below the gap: by a bubble for order 2, then by the constant that is still missing.
void lower(Vector& bernstein, const Samples& gap, EdgePieces& pieces)
{
  const Excess excess(bernstein, gap, pieces);
  if (excess.isRoundOff())
    return;
  const double kappa = bernstein.size() == 3 ? excess.bubble() : 0.0;
  if (kappa > 0.0)
    bernstein[1] -= 0.5 * kappa; // t (1 - t) is half the middle Bernstein polynomial
  const double constant = excess.left(kappa);
  for (double& coefficient : bernstein)
    coefficient -= constant;
}

/// int g L_k on a facet.
Vector gapMoments(const Samples& gap, const MomentBasis& basis, double measure)
{
  Vector moments(std::size_t(basis.size()), 0.0), L(moments.size());
  for (int q = 0; q < gap.rule.size(); ++q) {
    basis.values(gap.rule.point(q), L.data());
    for (std::size_t k = 0; k < moments.size(); ++k)
      moments[k] += measure * gap.rule.weights[std::size_t(q)] * gap.values[std::size_t(q)] * L[k];
  }
  return moments;
}

/// The gap at the nodes of a facet.
std::array<double, 3> nodalGaps(int order, const ContactFacet& facet, const SampledFunction& gap)
{
  const auto& [a, b] = facet.points;
  const Direction middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.0};
  return {valueAt(gap, 2, a.data()), valueAt(gap, 2, b.data()), order == 1 ? 0.0 : valueAt(gap, 2, middle.data())};
}

/// The ends of a facet, in the order of ContactFacet::nodes.
DataSampler::Vertices endsOf(const ContactFacet& facet)
{
  return {facet.points[0].data(), facet.points[1].data(), nullptr, nullptr};
}

} // namespace

GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets, int degree,
                  const std::vector<FacetGap>& gaps)
{
  GapBound bound;
  const MomentBasis basis = facetBasis(2, degree);
  EdgePieces pieces;
  std::size_t first = 0;
  for (const FacetGap& gap : gaps) {
    DataSampler sampler({gap.function}, 2);
    const std::size_t end = first + std::size_t(gap.numFacets);
    const double scale = sampler.scaleOn([&](const DataSampler::Visit& measure) {
      for (std::size_t f = first; f < end; ++f)
        measure(1, endsOf(facets[f]));
    });
    Doubt doubt;
    for (std::size_t f = first; f < end; ++f) {
      const BodyModel& body = *bodies[std::size_t(facets[f].dirichletBody)];
      const Samples samples = sampler.sample(1, endsOf(facets[f]), scale);
      Vector bernstein = interpolant(body.nodes.order, nodalGaps(body.nodes.order, facets[f], gap.function));
      lower(bernstein, samples, pieces);
      const Vector moments = gapMoments(samples, basis, facets[f].measure);
      bound.bernstein.insert(bound.bernstein.end(), bernstein.begin(), bernstein.end());
      bound.moments.insert(bound.moments.end(), moments.begin(), moments.end());
      int vertices[3];
      facetVertices(body.mesh, facets[f].dirichlet, vertices);
      doubt.add(samples, body.mesh, 1, vertices);
    }
    if (doubt)
      bound.caveat += fmt::format("the integrals of the gap are not certain near {} ({}). ", doubt.place, doubt.size());
    first = end;
  }
  return bound;
}

} // namespace ndframe
