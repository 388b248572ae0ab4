#include "ndframe/admissibility/gap_bound.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "doubt.hpp"
#include "edge_pieces.hpp"
#include "triangle_pieces.hpp"

namespace ndframe
{
namespace
{

/// A gap that differs from its interpolant by less, relative to its size, is the interpolant.
constexpr double roundOff = 1e-12;

/// Bernstein coefficients of the interpolant from the values at ContactPatch::nodes, in their order.
Vector interpolant(int dim, int order, const std::array<double, mostFacetNodes>& atNodes)
{
  Vector bernstein(atNodes.begin(), atNodes.begin() + numFacetNodes(dim, order));
  const FacetEdges edges = facetEdges(dim);
  for (int e = 0; order == 2 && e < edges.size; ++e) {
    const auto& [a, b] = edges.ends[e];
    double& middle = bernstein[std::size_t(dim) + std::size_t(e)];
    middle = 2.0 * middle - 0.5 * (atNodes[std::size_t(a)] + atNodes[std::size_t(b)]);
  }
  return bernstein;
}

double onEdge(const Vector& bernstein, const double* lambda)
{
  const double t = lambda[1], s = 1.0 - t;
  if (bernstein.size() == 2)
    return s * bernstein[0] + t * bernstein[1];
  return s * s * bernstein[0] + 2.0 * s * t * bernstein[2] + t * t * bernstein[1];
}

double onTriangle(const Vector& bernstein, const double* lambda)
{
  double value = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    value += (bernstein.size() == 3 ? lambda[a] : lambda[a] * lambda[a]) * bernstein[a];
  for (std::size_t e = 3; e < bernstein.size(); ++e) {
    const auto& ends = facetEdges(3).ends[e - 3];
    value += 2.0 * lambda[ends[0]] * lambda[ends[1]] * bernstein[e];
  }
  return value;
}

/// Polynomials on the pieces of patches of either kind, and what they miss.
struct FacetPieces
{
  EdgePieces edges;
  TrianglePieces triangles;

  double upperBound(int dim, const Samples::Piece& piece, const double* values)
  {
    return dim == 2 ? edges.upperBound(*piece.rule, values) : triangles.upperBound(*piece.rule, values);
  }
  double distance(int dim, const Samples::Piece& piece)
  {
    return dim == 2 ? EdgePieces::interpolationFactor(*piece.rule) * piece.error : triangles.distance(piece);
  }
};

/// The interpolant minus the gap on a patch, on every piece a polynomial and an error.
class Excess
{
public:
  Excess(int dim, const Vector& bernstein, const Samples& gap, FacetPieces& pieces)
      : dim_(dim), gap_(gap), pieces_(pieces)
  {
    const auto& value = dim == 2 ? onEdge : onTriangle;
    for (int i = 0; i < gap.rule.size(); ++i)
      values_.push_back(value(bernstein, gap.rule.point(i)) - gap.values[std::size_t(i)]);
  }

  bool isRoundOff() const
  {
    const auto isSmall = [this](double value) { return std::abs(value) <= roundOff * gap_.scale; };
    return std::all_of(values_.begin(), values_.end(), isSmall) &&
           std::all_of(gap_.pieces.begin(), gap_.pieces.end(),
                       [&](const auto& piece) { return isSmall(dim_ == 2 ? piece.error : piece.normError); });
  }

  /// An upper bound of what is left of it less kappa t (1 - t), 0 when that is nowhere positive but for round-off.
  double left(double kappa) const
  {
    Vector rest = values_;
    for (std::size_t i = 0; kappa > 0.0 && i < rest.size(); ++i)
      rest[i] -= kappa * gap_.rule.point(int(i))[0] * gap_.rule.point(int(i))[1];
    double largest = 0.0;
    for (const auto& piece : gap_.pieces)
      largest =
          std::max(largest, pieces_.upperBound(dim_, piece, rest.data() + piece.first) + pieces_.distance(dim_, piece));
    return largest <= roundOff * gap_.scale ? 0.0 : largest;
  }

  /// On an edge, about the smallest kappa that leaves no more than a very large one.
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
  int dim_;
  const Samples& gap_;
  FacetPieces& pieces_;
  Vector values_;
};

/// Lowers the interpolant below the gap: by a bubble on edges of order 2, then by the constant that is still missing.
void lower(int dim, Vector& bernstein, const Samples& gap, FacetPieces& pieces)
{
  const Excess excess(dim, bernstein, gap, pieces);
  if (excess.isRoundOff())
    return;
  const double kappa = dim == 2 && bernstein.size() == 3 ? excess.bubble() : 0.0;
  if (kappa > 0.0)
    bernstein[2] -= 0.5 * kappa; // t (1 - t) is half the middle Bernstein polynomial
  const double constant = excess.left(kappa);
  for (double& coefficient : bernstein)
    coefficient -= constant;
}

/// int g L_k on a patch.
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

/// The gap at the nodes of a patch.
std::array<double, mostFacetNodes> nodalGaps(int order, const ContactPatch& patch, const SampledFunction& gap)
{
  const auto dim = std::size_t(patch.dim);
  std::array<double, mostFacetNodes> values{};
  for (std::size_t a = 0; a < dim; ++a)
    values[a] = valueAt(gap, patch.dim, patch.points[a].data());
  const FacetEdges edges = facetEdges(patch.dim);
  for (int e = 0; order == 2 && e < edges.size; ++e) {
    const auto& [a, b] = edges.ends[e];
    Direction middle{};
    for (std::size_t k = 0; k < dim; ++k)
      middle[k] = 0.5 * (patch.points[std::size_t(a)][k] + patch.points[std::size_t(b)][k]);
    values[dim + std::size_t(e)] = valueAt(gap, patch.dim, middle.data());
  }
  return values;
}

/// The vertices of a patch, in the order of ContactPatch::nodes.
DataSampler::Vertices verticesOf(const ContactPatch& patch)
{
  return {patch.points[0].data(), patch.points[1].data(), patch.dim == 3 ? patch.points[2].data() : nullptr, nullptr};
}

} // namespace

GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches, int degree,
                  const std::vector<PatchGap>& gaps)
{
  GapBound bound;
  const int dim = dimOf(patches);
  const MomentBasis basis = facetBasis(dim, degree);
  FacetPieces pieces;
  std::size_t first = 0;
  for (const PatchGap& gap : gaps) {
    DataSampler sampler({gap.function}, dim);
    const std::size_t end = first + std::size_t(gap.numPatches);
    const double scale = sampler.scaleOn([&](const DataSampler::Visit& measure) {
      for (std::size_t f = first; f < end; ++f)
        measure(dim - 1, verticesOf(patches[f]));
    });
    Doubt doubt;
    for (std::size_t f = first; f < end; ++f) {
      const BodyModel& body = *bodies[std::size_t(patches[f].sides[0].body)];
      const Samples samples = sampler.sample(dim - 1, verticesOf(patches[f]), scale);
      const int order = body.nodes.order;
      Vector bernstein = interpolant(dim, order, nodalGaps(order, patches[f], gap.function));
      lower(dim, bernstein, samples, pieces);
      const Vector moments = gapMoments(samples, basis, patches[f].measure);
      bound.bernstein.insert(bound.bernstein.end(), bernstein.begin(), bernstein.end());
      bound.moments.insert(bound.moments.end(), moments.begin(), moments.end());
      int vertices[3];
      facetVertices(body.mesh, patches[f].sides[0].facet, vertices);
      doubt.add(samples, body.mesh, dim - 1, vertices);
      const bool isCharged = !samples.areCertain() && std::isfinite(samples.uncertainty);
      bound.unsure.push_back(isCharged ? samples.uncertainty * samples.scale : 0.0);
    }
    if (doubt && !std::isfinite(doubt.uncertainty))
      bound.caveat += fmt::format("the integrals of the gap are not certain near {} ({}). ", doubt.place, doubt.size());
    first = end;
  }
  if (largestEntry(bound.unsure) == 0.0)
    bound.unsure.clear();
  return bound;
}

} // namespace ndframe
