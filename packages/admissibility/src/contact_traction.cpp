#include "ndframe/admissibility/contact_traction.hpp"

#include <algorithm>
#include <limits>

#include "ndframe/admissibility/edge_functions.hpp"
#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

constexpr int verticesPerFacet = 2;

/// Bernstein polynomials of degree q on an edge.
void bernsteinValues(int degree, const double* lambda, double* B)
{
  double binomial = 1.0;
  for (int i = 0; i <= degree; ++i) {
    B[i] = binomial;
    for (int j = 0; j < degree; ++j)
      B[i] *= lambda[j < i ? 1 : 0];
    binomial *= double(degree - i) / double(i + 1);
  }
}

/// 1/|f| times the moments of the share of vertex a in the nodal function i: entry ((a * (order + 1)) + i) * modes + k.
/// Order 1: the unit force at a times int lambda_a N_i; order 2: int lambda_a N_i L_k (class Shares).
std::vector<double> nodalShares(int order, int degree)
{
  const MomentBasis basis = facetBasis(2, degree);
  const auto modes = std::size_t(basis.size()), nodes = std::size_t(order) + 1;
  std::vector<double> shares(verticesPerFacet * nodes * modes, 0.0), unit(modes);
  const QuadratureRule rule = simplexRule(1, 1 + order + degree);
  std::array<double, 3> N{};
  for (int q = 0; q < rule.size(); ++q) {
    edgeFunctions(order, rule.point(q), N.data());
    basis.values(rule.point(q), unit.data());
    for (int a = 0; a < verticesPerFacet; ++a) {
      if (order == 1)
        basis.vertexForce(a, unit.data());
      for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t k = 0; k < modes; ++k)
          shares[(std::size_t(a) * nodes + i) * modes + k] +=
              rule.weights[std::size_t(q)] * rule.point(q)[a] * N[i] * unit[k];
    }
  }
  return shares;
}

/// One facet's shares as a body feels them. The body runs along the facet backwards: vertices change places, modes of
/// odd degree change sign.
void addFacetShares(const ContactFacet& facet, const ContactTraction& traction, std::size_t f, bool isNeumann, int dim,
                    Vector& all)
{
  const auto modes = std::size_t(traction.degree) + 1;
  const bool backwards = isNeumann && facet.reversed;
  for (std::size_t a = 0; a < verticesPerFacet; ++a) {
    const std::size_t first = (f * verticesPerFacet + (backwards ? 1 - a : a)) * modes;
    for (std::size_t k = 0; k < modes; ++k) {
      const double sign = (backwards && k % 2 == 1) != isNeumann ? -1.0 : 1.0;
      for (std::size_t i = 0; i < std::size_t(dim); ++i)
        all.push_back(sign * (facet.turns ? traction.vectors[(first + k) * 2 + i]
                                          : traction.shares[first + k] * facet.normal[i]));
    }
  }
}

} // namespace

Direction ContactFacet::normalAt(std::size_t node) const
{
  if (!turns)
    return normal;
  if (node < 2)
    return ends[node];
  return {0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1]), 0.0};
}

Vector ContactTraction::moments(int facet) const
{
  const auto modes = std::size_t(degree) + 1, first = std::size_t(facet) * verticesPerFacet * modes;
  Vector total(modes, 0.0);
  for (std::size_t a = 0; a < verticesPerFacet; ++a)
    for (std::size_t k = 0; k < modes; ++k)
      total[k] += shares[first + a * modes + k];
  return total;
}

DenseMatrix bernsteinOfMoments(int degree)
{
  const MomentBasis basis = facetBasis(2, degree);
  const int size = degree + 1;
  const QuadratureRule rule = simplexRule(1, 2 * degree);
  DenseMatrix mass(size, size), mixed(size, size);
  Vector B(std::size_t(size), 0.0), L(std::size_t(size), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    bernsteinValues(degree, rule.point(q), B.data());
    basis.values(rule.point(q), L.data());
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        mass(i, j) += rule.weights[std::size_t(q)] * B[std::size_t(i)] * B[std::size_t(j)];
        mixed(i, j) += rule.weights[std::size_t(q)] * B[std::size_t(i)] * L[std::size_t(j)];
      }
  }
  const DenseCholesky factor(std::move(mass));
  DenseMatrix coefficients(size, size);
  for (int j = 0; j < size; ++j) {
    const Vector column = factor.solve(mixed.column(j));
    std::copy(column.begin(), column.end(), coefficients.col(j));
  }
  return coefficients;
}

double largestBernstein(const ContactTraction& traction, const std::vector<ContactFacet>& facets)
{
  const DenseMatrix toBernstein = bernsteinOfMoments(traction.degree);
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Vector coefficients = multiply(toBernstein, traction.moments(int(f)));
    largest = std::max(largest, *std::max_element(coefficients.begin(), coefficients.end()) / facets[f].measure);
  }
  return largest;
}

ContactTraction tractionFromNodes(const std::vector<ContactFacet>& facets, const Vector& nodal, int order, int degree)
{
  NDFRAME_ASSERT(order <= degree, "a traction of the displacements' order must fit the degree");
  const auto table = nodalShares(order, degree);
  const auto modes = std::size_t(degree) + 1, nodes = std::size_t(order) + 1;
  ContactTraction traction{degree, Vector(facets.size() * verticesPerFacet * modes, 0.0),
                           turnedShares(facets, nodal, order, degree)};
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t a = 0; a < verticesPerFacet; ++a)
      for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t k = 0; k < modes; ++k)
          traction.shares[(f * verticesPerFacet + a) * modes + k] +=
              facets[f].measure * nodal[std::size_t(facets[f].nodes[i])] * table[(a * nodes + i) * modes + k];
  return traction;
}

Vector contactShares(const std::vector<ContactFacet>& facets, const ContactTraction& onDirichlet,
                     const ContactTraction& onNeumann, int body, int dim)
{
  Vector shares;
  for (std::size_t f = 0; f < facets.size(); ++f)
    if (facets[f].dirichletBody == body)
      addFacetShares(facets[f], onDirichlet, f, false, dim, shares);
    else if (facets[f].neumannBody == body)
      addFacetShares(facets[f], onNeumann, f, true, dim, shares);
  return shares;
}

} // namespace ndframe
