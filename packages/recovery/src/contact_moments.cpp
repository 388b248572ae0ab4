#include "ndframe/recovery/contact_moments.hpp"

#include "edge_functions.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/recovery/contact_nodes.hpp"

namespace ndframe
{
Vector jumpMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets,
                   const std::vector<Vector>& displacement, int degree)
{
  const int order = bodies.front()->nodes.order;
  const DenseMatrix moments = edgeMoments(order, degree);
  Vector all;
  for (const ContactFacet& facet : facets) {
    const auto jump = facetJump(bodies, facet, displacement);
    for (int k = 0; k <= degree; ++k) {
      all.push_back(0.0);
      for (int i = 0; i <= order; ++i)
        all.back() += facet.measure * jump[std::size_t(i)] * moments(i, k);
    }
  }
  return all;
}

Vector nodalMoments(const std::vector<ContactFacet>& facets, const Vector& nodal, int order, int degree)
{
  const DenseMatrix moments = edgeMoments(order, degree);
  Vector all;
  for (const ContactFacet& facet : facets)
    for (int k = 0; k <= degree; ++k) {
      all.push_back(0.0);
      for (int i = 0; i <= order; ++i)
        all.back() += facet.measure * nodal[std::size_t(facet.nodes[std::size_t(i)])] * moments(i, k);
    }
  return all;
}

Vector contactForces(const BodyModel& body, int bodyIndex, const std::vector<ContactFacet>& facets,
                     const ContactTraction& onDirichlet, const ContactTraction& onNeumann)
{
  Vector force(std::size_t(body.numDofs()), 0.0);
  const DenseMatrix moments = edgeMoments(body.nodes.order, onDirichlet.degree);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const ContactFacet& facet = facets[f];
    const bool isDirichlet = facet.dirichletBody == bodyIndex;
    if (!isDirichlet && facet.neumannBody != bodyIndex)
      continue;
    const auto nodes = contactNodes(body, facet, isDirichlet);
    const Vector normal = multiply(moments, (isDirichlet ? onDirichlet : onNeumann).moments(int(f)));
    for (std::size_t i = 0; i < normal.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        force[std::size_t(nodes[i]) * 2 + k] += (isDirichlet ? normal[i] : -normal[i]) * facet.normal[k];
  }
  return force;
}

Vector contactContributions(const std::vector<ContactFacet>& facets, const ContactTraction& traction, const Vector& w)
{
  const auto modes = std::size_t(traction.degree + 1);
  Vector contributions;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Vector t = traction.moments(int(f));
    double work = 0.0;
    for (std::size_t k = 0; k < modes; ++k)
      work += t[k] * w[f * modes + k];
    contributions.push_back(2.0 * work / facets[f].measure);
  }
  return contributions;
}

std::vector<double> facetContactMatrix(int order)
{
  const QuadratureRule rule = simplexRule(1, 2 * order);
  const auto nodes = std::size_t(order + 1);
  std::vector<double> matrix(nodes * nodes, 0.0);
  double N[3];
  for (int g = 0; g < rule.size(); ++g) {
    edgeFunctions(order, rule.point(g), N);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        matrix[i * nodes + j] += rule.weights[std::size_t(g)] * N[i] * N[j];
  }
  return matrix;
}

} // namespace ndframe
