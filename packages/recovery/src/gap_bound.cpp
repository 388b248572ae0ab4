#include "ndframe/recovery/gap_bound.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "edge_pieces.hpp"
#include "ndframe/recovery/contact_nodes.hpp"

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

/// Lowers the interpolant below the sampled gap. For order 2 its excess vanishes at the vertices, so that
/// kappa t (1 - t) with kappa >= excess / (t (1 - t)) takes it off.
void lower(Vector& bernstein, const Samples& gap, EdgePieces& pieces)
{
  Vector excess(gap.values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < excess.size(); ++i) {
    excess[i] = valueAt(bernstein, gap.rule.point(int(i))[1]) - gap.values[i];
    largest = std::max(largest, std::abs(excess[i]));
  }
  if (largest <= roundOff * gap.scale)
    return;
  const bool quadratic = bernstein.size() == 3;
  for (std::size_t i = 0; quadratic && i < excess.size(); ++i)
    excess[i] /= gap.rule.point(int(i))[0] * gap.rule.point(int(i))[1];
  double bound = 0.0;
  for (const auto& piece : gap.pieces)
    bound = std::max(bound, pieces.upperBound(*piece.rule, excess.data() + piece.first));
  if (quadratic)
    bernstein[1] -= 0.5 * bound; // t (1 - t) is half the middle Bernstein polynomial
  else
    for (double& coefficient : bernstein)
      coefficient -= bound;
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

/// The gap at the nodes of every facet.
std::vector<std::array<double, 3>> nodalGaps(const std::vector<const BodyModel*>& bodies,
                                             const std::vector<ContactFacet>& facets, const FacetGap& gap)
{
  std::vector<std::array<double, 3>> all(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const BodyModel& body = *bodies[std::size_t(facets[f].dirichletBody)];
    const auto nodes = contactNodes(body, facets[f], true);
    for (std::size_t i = 0; i <= std::size_t(body.nodes.order); ++i)
      all[f][i] = gap(int(f), body.nodes.point(nodes[i]));
  }
  return all;
}

/// The largest gap between two bodies: what round-off in their gap is relative to.
using GapSizes = std::map<std::pair<int, int>, double>;

GapSizes gapSizes(const std::vector<ContactFacet>& facets, const std::vector<std::array<double, 3>>& nodal)
{
  GapSizes sizes;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const double g : nodal[f]) {
      double& size = sizes[{facets[f].dirichletBody, facets[f].neumannBody}];
      size = std::max(size, std::abs(g));
    }
  return sizes;
}

} // namespace

GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets, int degree,
                  const FacetGap& gap)
{
  GapBound bound;
  const MomentBasis basis = facetBasis(2, degree);
  EdgePieces pieces;
  double uncertainty = 0.0;
  const auto nodal = nodalGaps(bodies, facets, gap);
  const GapSizes sizes = gapSizes(facets, nodal);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const BodyModel& body = *bodies[std::size_t(facets[f].dirichletBody)];
    const auto nodes = contactNodes(body, facets[f], true);
    const std::array<const double*, 2> ends{body.nodes.point(nodes[0]), body.nodes.point(nodes[1])};
    const Samples samples =
        sampleAdaptively(1, ends.data(), 2, 1, sizes.at({facets[f].dirichletBody, facets[f].neumannBody}),
                         [&](const double* x, double* g) { *g = gap(int(f), x); });
    Vector bernstein = interpolant(body.nodes.order, nodal[f]);
    lower(bernstein, samples, pieces);
    const Vector moments = gapMoments(samples, basis, facets[f].measure);
    bound.bernstein.insert(bound.bernstein.end(), bernstein.begin(), bernstein.end());
    bound.moments.insert(bound.moments.end(), moments.begin(), moments.end());
    uncertainty = std::max(uncertainty, samples.uncertainty);
  }
  if (uncertainty > 0.0)
    bound.caveat = fmt::format("the gap varies too abruptly inside a facet to be bounded with certainty (to {:.1g} of "
                               "its size there). ",
                               uncertainty);
  return bound;
}

} // namespace ndframe
