#include "ndframe/admissibility/prescribed_charge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "doubt.hpp"
#include "edge_pieces.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/mechanics/kernels.hpp"
#include "prescribed_displacement.hpp"

namespace ndframe
{
namespace
{

/// Data that differ from their interpolant by less, relative to their size, are the interpolant.
constexpr double roundOff = 1e-12;
/// The same for values at the ends of pieces, to which polynomials through Gauss points extend round-off.
constexpr double continuity = 1e-10;

/// delta at the samples, component by component: dim rows of samples.
Vector difference(const BodyModel& body, const Samples& samples, const Vector& nodal)
{
  const int dim = body.mesh.dim, points = samples.rule.size();
  Vector delta(std::size_t(dim) * std::size_t(points));
  withDimAndOrder(dim, body.nodes.order, [&](auto d, auto p) {
    constexpr int nodes = Lagrange<d() - 1, p()>::nodes;
    double N[nodes];
    for (int q = 0; q < points; ++q) {
      Lagrange<d() - 1, p()>::values(samples.rule.point(q), N);
      for (int i = 0; i < dim; ++i) {
        double& value = delta[std::size_t(i) * std::size_t(points) + std::size_t(q)] =
            samples.values[std::size_t(q) * std::size_t(dim) + std::size_t(i)];
        for (int a = 0; a < nodes; ++a)
          value -= N[a] * nodal[std::size_t(a) * std::size_t(dim) + std::size_t(i)];
      }
    }
  });
  return delta;
}

/// K eps : eps of the gradient sum_v value_v grad lambda_v at one point; value: per vertex of the facet and component.
double energyDensity(const Elasticity& law, const double* grad0, const double* grad1, const double (&value)[2][2])
{
  const double strain[3] = {
      value[0][0] * grad0[0] + value[1][0] * grad1[0], value[0][1] * grad0[1] + value[1][1] * grad1[1],
      value[0][0] * grad0[1] + value[1][0] * grad1[1] + value[0][1] * grad0[0] + value[1][1] * grad1[0]};
  double density = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      density += strain[i] * law(i, j) * strain[j];
  return density;
}

/// |w|^2 = |E| int_0^1 K eps : eps dt with grad w = (delta - t delta') grad lambda_0 + (delta + (1 - t) delta')
/// grad lambda_1 for the facet's vertices 0 and 1.
double liftedEnergy(const BodyModel& body, Facet facet, const Samples& samples, const Vector& delta, EdgePieces& pieces)
{
  double points[6], gradLambda[6], energy = 0.0;
  cellPoints(body.mesh, facet.cell, points);
  const double measure = barycentricGradients<2>(points, gradLambda);
  const int* local = facetLocalNodes(2, 1, facet.local);
  for (const auto& piece : samples.pieces) {
    const std::array<const double*, 2> values{delta.data() + piece.first,
                                              delta.data() + samples.rule.size() + piece.first};
    const std::array<Vector, 2> slopes{pieces.derivatives(piece, values[0]), pieces.derivatives(piece, values[1])};
    for (int q = 0; q < piece.rule->size(); ++q) {
      const double t = samples.rule.point(piece.first + q)[1];
      double value[2][2];
      for (std::size_t i = 0; i < 2; ++i) {
        value[0][i] = values[i][q] - t * slopes[i][std::size_t(q)];
        value[1][i] = values[i][q] + (1.0 - t) * slopes[i][std::size_t(q)];
      }
      energy += measure * samples.rule.weights[std::size_t(piece.first) + std::size_t(q)] *
                energyDensity(body.laws(facet.cell), gradLambda + std::ptrdiff_t(2) * local[0],
                              gradLambda + std::ptrdiff_t(2) * local[1], value);
    }
  }
  return energy;
}

/// Where delta jumps its lift has no finite energy: the polynomials of neighbouring pieces have to meet, and delta has
/// to vanish at the facet's ends, as its interpolant does for the facets beside.
bool isContinuous(const Samples& samples, const Vector& delta, int dim, EdgePieces& pieces)
{
  auto sorted = samples.pieces;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return EdgePieces::ends(a)[0] + EdgePieces::ends(a)[1] < EdgePieces::ends(b)[0] + EdgePieces::ends(b)[1];
  });
  for (int i = 0; i < dim; ++i) {
    double reached = 0.0, error = 0.0;
    for (const auto& piece : sorted) {
      auto values = pieces.endValues(*piece.rule, delta.data() + std::ptrdiff_t(i) * samples.rule.size() + piece.first);
      if (const auto ends = EdgePieces::ends(piece); ends[0] > ends[1])
        std::swap(values[0], values[1]);
      const double missed = EdgePieces::interpolationFactor(*piece.rule) * piece.error;
      if (std::abs(values[0] - reached) > error + missed + continuity * samples.scale)
        return false;
      reached = values[1];
      error = missed;
    }
    if (std::abs(reached) > error + continuity * samples.scale)
      return false;
  }
  return true;
}

/// A bound of |w| for what the polynomials on the pieces miss of delta: at most e and its slope e' there, times `gain`.
/// |grad w| <= (|e| + |e'|) sum_v |grad lambda_v|, and the largest eigenvalue of K is below its trace in Mandel's form.
double missedEnergy(const BodyModel& body, Facet facet, const Samples& samples, double gain)
{
  double points[6], gradLambda[6], square = 0.0, trace = 0.0;
  cellPoints(body.mesh, facet.cell, points);
  const double measure = barycentricGradients<2>(points, gradLambda);
  const int* local = facetLocalNodes(2, 1, facet.local);
  double gradients = 0.0;
  for (int v = 0; v < 2; ++v)
    gradients += std::hypot(gradLambda[std::ptrdiff_t(2) * local[v]], gradLambda[std::ptrdiff_t(2) * local[v] + 1]);
  for (int i = 0; i < 3; ++i)
    trace += (i < 2 ? 1.0 : 2.0) * body.laws(facet.cell)(i, i);
  for (const auto& piece : samples.pieces) {
    const double value = EdgePieces::interpolationFactor(*piece.rule) * piece.error, slope = piece.slopeError;
    if (value + slope > 0.0)
      square += piece.fraction * std::pow(value + slope / piece.fraction, 2);
  }
  return measure * trace * std::pow(gain * gradients, 2) * square;
}

DataSampler::Vertices verticesOf(const Mesh& mesh, Facet facet)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  DataSampler::Vertices points{};
  for (std::size_t v = 0; v < std::size_t(mesh.dim); ++v)
    points[v] = mesh.point(vertices[v]);
  return points;
}

/// Replaces the functions' values at the samples by displacements.
void toDisplacements(const PrescribedDisplacement& prescribed, int dim, Samples& samples)
{
  Vector u(std::size_t(samples.rule.size()) * std::size_t(dim));
  for (int q = 0; q < samples.rule.size(); ++q)
    prescribed.displacement(samples.values.data() + std::size_t(q) * prescribed.functions().size(),
                            u.data() + std::ptrdiff_t(q) * dim);
  samples.values = std::move(u);
}

/// Adds up what the facets of one set of supports cost.
class Charge
{
public:
  explicit Charge(const BodyModel& body) : body_(body) {}

  void add(const HeldFacets& held);
  PrescribedCharge result(const Comm& parts) const;

private:
  void addFacet(Facet facet, const Samples& samples, const Vector& delta, double gain);

  const BodyModel& body_;
  std::map<int, double> norms_; ///< per cell: several of its facets may be prescribed
  double uncharged_ = 0.0;
  Doubt doubt_;
  EdgePieces pieces_;
};

void Charge::add(const HeldFacets& held)
{
  const PrescribedDisplacement prescribed(body_, held.supports);
  const int dim = body_.mesh.dim;
  DataSampler sampler(prescribed.functions(), dim);
  const double scale = sampler.scaleOn([&](const DataSampler::Visit& measure) {
    for (const Facet facet : held.facets)
      measure(dim - 1, verticesOf(body_.mesh, facet));
  });
  for (const Facet facet : held.facets) {
    Samples samples = sampler.sample(dim - 1, verticesOf(body_.mesh, facet), scale);
    int vertices[3];
    facetVertices(body_.mesh, facet, vertices);
    doubt_.add(samples, body_.mesh, dim - 1, vertices);
    toDisplacements(prescribed, dim, samples);
    addFacet(facet, samples, difference(body_, samples, prescribed.atNodes(facet)), prescribed.gain());
  }
}

void Charge::addFacet(Facet facet, const Samples& samples, const Vector& delta, double gain)
{
  const double missed = samples.spread * gain;
  if (largestEntry(delta) + missed <= roundOff * samples.scale)
    return;
  if (body_.mesh.dim == 2 && !isContinuous(samples, delta, 2, pieces_))
    norms_[facet.cell] = std::numeric_limits<double>::infinity();
  else if (body_.mesh.dim == 2)
    norms_[facet.cell] += std::sqrt(liftedEnergy(body_, facet, samples, delta, pieces_)) +
                          std::sqrt(missedEnergy(body_, facet, samples, gain));
  else
    uncharged_ = std::max(uncharged_, largestEntry(delta) + missed);
}

PrescribedCharge Charge::result(const Comm& parts) const
{
  PrescribedCharge result;
  for (const auto& entry : norms_)
    result.charge = std::hypot(result.charge, entry.second);
  Vector uncharged{uncharged_};
  takeLargest(uncharged, parts);
  if (uncharged[0] > 0.0)
    result.caveat += fmt::format("the displacements prescribed on {} are met at nodes only (off by up to {:.2g} "
                                 "between them), which the bound accounts for in 2D only. ",
                                 body_.name, uncharged[0]);
  if (doubt_)
    result.caveat += fmt::format("the displacements prescribed on {} are not certain near {} ({}). ", body_.name,
                                 doubt_.place, doubt_.size());
  if (!std::isfinite(result.charge)) {
    result.charge = 0.0;
    result.caveat +=
        fmt::format("the displacements prescribed on {} are not shown to be those of a field of finite energy "
                    "(they jump, or their slope is not bounded). ",
                    body_.name);
  }
  return result;
}

} // namespace

PrescribedCharge chargePrescribed(const BodyModel& body, const Comm& parts)
{
  Charge charge(body);
  for (const auto& held : varyingFacets(body))
    charge.add(held);
  return charge.result(parts);
}

} // namespace ndframe
