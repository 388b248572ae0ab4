#include "ndframe/recovery/prescribed_charge.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "edge_pieces.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

/// Data that differ from their interpolant by less, relative to their size, are the interpolant.
constexpr double roundOff = 1e-12;

/// The displacement that all supports of a facet prescribe together, as a vector along their directions.
class PrescribedDisplacement
{
public:
  PrescribedDisplacement(const BodyModel& body, std::vector<const Support*> supports)
      : body_(body), supports_(std::move(supports))
  {}

  bool isConstant() const
  {
    return std::all_of(supports_.begin(), supports_.end(), [](const Support* s) { return s->isConstant(); });
  }

  void operator()(const double* x, double* u) const
  {
    const int dim = body_.mesh.dim;
    ConstraintSet combined(dim, 1.0); // the reduction to orthonormal directions that nodes get
    for (const Support* support : supports_) {
      const auto directions = support->directions(body_.mesh);
      for (std::size_t k = 0; k < directions.size(); ++k)
        combined.add({0, directions[k], support->value(dim, int(k), x)});
    }
    const ConstraintSet::Node& node = combined.nodes().at(0);
    std::fill_n(u, dim, 0.0);
    for (std::size_t j = 0; j < std::size_t(node.count); ++j)
      for (int i = 0; i < dim; ++i)
        u[i] += node.value[j] * node.direction[j][std::size_t(i)];
  }

private:
  const BodyModel& body_;
  std::vector<const Support*> supports_;
};

/// The facets on which something varies, with what is prescribed there.
std::vector<std::pair<Facet, PrescribedDisplacement>> varyingFacets(const BodyModel& body)
{
  const int perCell = body.mesh.dim + 1;
  std::map<int, std::vector<const Support*>> supports;
  for (const auto& support : body.supports)
    for (const Facet facet : support->facets(body.mesh))
      supports[facet.cell * perCell + facet.local].push_back(support.get());
  std::vector<std::pair<Facet, PrescribedDisplacement>> facets;
  for (const auto& [number, onFacet] : supports)
    if (PrescribedDisplacement prescribed(body, onFacet); !prescribed.isConstant())
      facets.emplace_back(Facet{number / perCell, number % perCell}, prescribed);
  return facets;
}

/// Values of the prescribed displacement at a facet's nodes, node by node.
Vector atNodes(const BodyModel& body, Facet facet, const PrescribedDisplacement& prescribed)
{
  int nodes[6];
  facetNodes(body.nodes, facet, nodes);
  Vector values(std::size_t(body.nodes.nodesPerFacet * body.mesh.dim));
  for (int a = 0; a < body.nodes.nodesPerFacet; ++a)
    prescribed(body.nodes.point(nodes[a]), values.data() + a * body.mesh.dim);
  return values;
}

double largest(const Vector& values)
{
  double size = 0.0;
  for (const double value : values)
    size = std::max(size, std::abs(value));
  return size;
}

/// delta at the samples, component by component: dim rows of samples.
Vector difference(const BodyModel& body, const Samples& samples, const Vector& nodal)
{
  const int dim = body.mesh.dim, points = samples.rule.size();
  Vector delta(std::size_t(dim * points));
  withDimAndOrder(dim, body.nodes.order, [&](auto d, auto p) {
    constexpr int nodes = Lagrange<d() - 1, p()>::nodes;
    double N[nodes];
    for (int q = 0; q < points; ++q) {
      Lagrange<d() - 1, p()>::values(samples.rule.point(q), N);
      for (int i = 0; i < dim; ++i) {
        double& value = delta[std::size_t(i * points + q)] = samples.values[std::size_t(q * dim + i)];
        for (int a = 0; a < nodes; ++a)
          value -= N[a] * nodal[std::size_t(a * dim + i)];
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
      energy += measure * samples.rule.weights[std::size_t(piece.first + q)] *
                energyDensity(body.law, gradLambda + 2 * local[0], gradLambda + 2 * local[1], value);
    }
  }
  return energy;
}

Samples sampleFacet(const BodyModel& body, Facet facet, double size, const PrescribedDisplacement& prescribed)
{
  int vertices[3];
  facetVertices(body.mesh, facet, vertices);
  std::array<const double*, 3> points{};
  for (std::size_t v = 0; v < std::size_t(body.mesh.dim); ++v)
    points[v] = body.mesh.point(vertices[v]);
  return sampleAdaptively(body.mesh.dim - 1, points.data(), body.mesh.dim, body.mesh.dim, size, prescribed);
}

} // namespace

PrescribedCharge chargePrescribed(const BodyModel& body)
{
  const auto facets = varyingFacets(body);
  double size = 0.0, uncertainty = 0.0, uncharged = 0.0;
  for (const auto& [facet, prescribed] : facets)
    size = std::max(size, largest(atNodes(body, facet, prescribed)));
  std::map<int, double> norms; // per cell: several of its facets may be prescribed
  EdgePieces pieces;
  for (const auto& [facet, prescribed] : facets) {
    const Samples samples = sampleFacet(body, facet, size, prescribed);
    const Vector delta = difference(body, samples, atNodes(body, facet, prescribed));
    uncertainty = std::max(uncertainty, samples.uncertainty);
    if (largest(delta) <= roundOff * samples.scale)
      continue;
    if (body.mesh.dim == 2)
      norms[facet.cell] += std::sqrt(liftedEnergy(body, facet, samples, delta, pieces));
    else
      uncharged = std::max(uncharged, largest(delta));
  }
  PrescribedCharge result;
  for (const auto& entry : norms)
    result.charge = std::hypot(result.charge, entry.second);
  if (uncharged > 0.0)
    result.caveat +=
        fmt::format("the displacements prescribed on {} are met at nodes only (up to {:.2g} between them), "
                    "which is charged in the plane only. ",
                    body.name, uncharged);
  if (uncertainty > 0.0)
    result.caveat += fmt::format("the displacements prescribed on {} vary too abruptly inside a facet. ", body.name);
  return result;
}

} // namespace ndframe
