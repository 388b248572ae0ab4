#include "ndframe/recovery/contact_moments.hpp"

#include <algorithm>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Values of the order + 1 nodal functions of an edge: its two ends, then (order 2) its middle.
void edgeFunctions(int order, const double* lambda, double* N)
{
  if (order == 1)
    Lagrange<1, 1>::values(lambda, N);
  else
    Lagrange<1, 2>::values(lambda, N);
}

/// 1/|f| int N_i L_k dS, node by node.
std::vector<double> functionMoments(int order, int degree)
{
  const MomentBasis basis = facetBasis(2, degree);
  const QuadratureRule rule = simplexRule(1, order + degree);
  const auto nodes = std::size_t(order + 1), modes = std::size_t(basis.size());
  std::vector<double> moments(nodes * modes, 0.0), L(modes);
  double N[3];
  for (int g = 0; g < rule.size(); ++g) {
    edgeFunctions(order, rule.point(g), N);
    basis.values(rule.point(g), L.data());
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t k = 0; k < modes; ++k)
        moments[i * modes + k] += rule.weights[std::size_t(g)] * N[i] * L[k];
  }
  return moments;
}

/// A body's node numbers on a contact facet in the facet's own order: ascending vertices of the Dirichlet body, middle.
std::array<int, 3> facetNodeNumbers(const BodyModel& body, Facet facet, bool reversed)
{
  std::array<int, 3> nodes{};
  facetNodes(body.nodes, facet, nodes.data());
  if ((nodes[0] > nodes[1]) != reversed)
    std::swap(nodes[0], nodes[1]);
  return nodes;
}

} // namespace

Vector jumpMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets,
                   const std::vector<Vector>& displacement, int degree)
{
  Vector all;
  for (const ContactFacet& facet : facets) {
    const BodyModel &first = *bodies[std::size_t(facet.dirichletBody)],
                    &second = *bodies[std::size_t(facet.neumannBody)];
    const int order = first.nodes.order;
    const auto moments = functionMoments(order, degree);
    const auto ours = facetNodeNumbers(first, facet.dirichlet, false),
               theirs = facetNodeNumbers(second, facet.neumann, facet.reversed);
    Vector jump(std::size_t(degree + 1), 0.0);
    for (std::size_t i = 0; i < std::size_t(order + 1); ++i) {
      double normal = 0.0;
      for (std::size_t k = 0; k < 2; ++k)
        normal += facet.normal[k] * (displacement[std::size_t(facet.dirichletBody)][std::size_t(ours[i]) * 2 + k] -
                                     displacement[std::size_t(facet.neumannBody)][std::size_t(theirs[i]) * 2 + k]);
      for (std::size_t k = 0; k < jump.size(); ++k)
        jump[k] += facet.measure * normal * moments[i * jump.size() + k];
    }
    all.insert(all.end(), jump.begin(), jump.end());
  }
  return all;
}

Vector nodalMoments(const std::vector<ContactFacet>& facets, const Vector& nodal, int order, int degree)
{
  const auto moments = functionMoments(order, degree);
  const auto modes = std::size_t(degree + 1);
  Vector all(facets.size() * modes, 0.0);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < std::size_t(order + 1); ++i)
      for (std::size_t k = 0; k < modes; ++k)
        all[f * modes + k] += facets[f].measure * nodal[std::size_t(facets[f].nodes[i])] * moments[i * modes + k];
  return all;
}

Vector contactForces(const BodyModel& body, int bodyIndex, const std::vector<ContactFacet>& facets,
                     const ContactTraction& onDirichlet, const ContactTraction& onNeumann)
{
  Vector force(std::size_t(body.numDofs()), 0.0);
  const auto moments = functionMoments(body.nodes.order, onDirichlet.degree);
  const auto modes = std::size_t(onDirichlet.degree + 1);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const ContactFacet& facet = facets[f];
    const bool isDirichlet = facet.dirichletBody == bodyIndex;
    if (!isDirichlet && facet.neumannBody != bodyIndex)
      continue;
    const auto nodes = isDirichlet ? facetNodeNumbers(body, facet.dirichlet, false)
                                   : facetNodeNumbers(body, facet.neumann, facet.reversed);
    const Vector t = (isDirichlet ? onDirichlet : onNeumann).moments(int(f));
    for (std::size_t i = 0; i < std::size_t(body.nodes.order + 1); ++i) {
      double normal = 0.0;
      for (std::size_t k = 0; k < modes; ++k)
        normal += t[k] * moments[i * modes + k];
      for (std::size_t k = 0; k < 2; ++k)
        force[std::size_t(nodes[i]) * 2 + k] += (isDirichlet ? normal : -normal) * facet.normal[k];
    }
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
