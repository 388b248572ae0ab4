#include "interface_misfit.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/smallest_stiffness.hpp"
#include "ndframe/assembly/cell_field.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// t n_c at points of a patch of the plane, as a force per length of the interface's first side.
std::vector<Direction> tractionAt(const ContactPatch& patch, const ContactTraction& traction, int number,
                                  const QuadratureRule& rule)
{
  const MomentBasis basis = facetBasis(2, traction.degree);
  const Vector moments = traction.moments(number);
  Vector L(moments.size());
  std::vector<Direction> values;
  for (int g = 0; g < rule.size(); ++g) {
    const double* lambda = rule.point(g);
    basis.values(lambda, L.data());
    const double t = dot(moments, L) / patch.measure;
    values.emplace_back();
    for (std::size_t k = 0; k < 2; ++k)
      values.back()[k] =
          t * (patch.turns ? lambda[0] * patch.ends[0][k] + lambda[1] * patch.ends[1][k] : patch.normal[k]);
  }
  return values;
}

/// int |t - K eps(u) nu|^2 over one side of a patch; t per length of this side.
template <int order>
double misfitOf(const BodyModel& body, const Vector& displacement, Facet own, const FacetNodes& nodes,
                const QuadratureRule& rule, const std::vector<Direction>& traction, double sign)
{
  const CellField<2, order> field(body, displacement, own.cell);
  double normal[2], strain[CellField<2, order>::strains], sigma[CellField<2, order>::strains], carried[2];
  const double length = facetNormal(body.mesh, own, normal);
  const int* vertices = body.mesh.cell(own.cell);
  double square = 0.0;
  for (int g = 0; g < rule.size(); ++g) {
    double lambda[3] = {};
    for (std::size_t end = 0; end < 2; ++end)
      lambda[std::find(vertices, vertices + 3, nodes[end]) - vertices] = rule.point(g)[end];
    field.evaluate(lambda, strain, sigma);
    divergenceForce<2>(normal, sigma, carried);
    for (std::size_t k = 0; k < 2; ++k)
      square +=
          length * rule.weights[std::size_t(g)] * std::pow(sign / length * traction[std::size_t(g)][k] - carried[k], 2);
  }
  return length * square;
}

} // namespace

double interfaceMisfit(const CertifiedScene& scene, const IntermediateField& field)
{
  NDFRAME_ASSERT(scene.bodies.front()->mesh.dim == 2, "sides that are cut are those of plane bodies");
  const QuadratureRule rule = simplexRule(1, 2 * scene.degree + 2);
  double square = 0.0;
  for (std::size_t f = 0; f < scene.patches.size(); ++f) {
    const ContactPatch& patch = scene.patches[f];
    for (std::size_t side = 0; side < 2; ++side) {
      const auto b = std::size_t(patch.sides[side].body);
      const BodyModel& body = *scene.bodies[b];
      const auto traction = tractionAt(patch, field.tractions[side], int(f), rule);
      const auto nodes = contactNodes(body, patch.sides[side]);
      const Facet own = patch.sides[side].facet;
      const double sign = sideSign(side) * patch.measure;
      square += (scene.order == 1 ? misfitOf<1>(body, field.displacement[b], own, nodes, rule, traction, sign)
                                  : misfitOf<2>(body, field.displacement[b], own, nodes, rule, traction, sign)) /
                smallestStiffness(body.laws(own.cell));
    }
  }
  const Vector gap = nodalMoments(scene.patches, nodalGap(scene.model), scene.order, scene.degree);
  const Vector opening = difference(jumpMoments(scene.bodies, scene.patches, scene.solved, scene.degree), gap);
  for (const double twice : contactContributions(scene.patches, field.tractions[0], opening))
    square += twice;
  return std::sqrt(std::max(0.0, square));
}

} // namespace ndframe
