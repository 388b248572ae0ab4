#include "ndframe/admissibility/contact_traction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Exponents of the Bernstein polynomials of degree q on a facet; on edges from the first vertex to the second.
std::vector<std::array<int, 3>> bernsteinPowers(int dim, int degree)
{
  std::vector<std::array<int, 3>> powers;
  for (int i = degree; i >= 0; --i)
    for (int j = degree - i; j >= (dim == 2 ? degree - i : 0); --j)
      powers.push_back({i, j, degree - i - j});
  return powers;
}

double factorial(int n)
{
  return n <= 1 ? 1.0 : n * factorial(n - 1);
}

/// Values of the Bernstein polynomials: degree! / (i! j! k!) lambda_0^i lambda_1^j lambda_2^k.
void bernsteinValues(int dim, const std::vector<std::array<int, 3>>& powers, const double* lambda, double* B)
{
  for (const auto& exponents : powers) {
    double value = factorial(exponents[0] + exponents[1] + exponents[2]);
    for (int d = 0; d < dim; ++d) {
      value /= factorial(exponents[std::size_t(d)]);
      for (int j = 0; j < exponents[std::size_t(d)]; ++j)
        value *= lambda[d];
    }
    *B++ = value;
  }
}

/// 1/|f| times the moments of the share of vertex a in the nodal function i: entry (a * nodes + i) * modes + k.
/// Order 1: the unit force at a times int lambda_a N_i; order 2: int lambda_a N_i L_k (class Shares).
std::vector<double> nodalShares(int dim, int order, int degree)
{
  const MomentBasis basis = facetBasis(dim, degree);
  const auto modes = std::size_t(basis.size()), nodes = std::size_t(numFacetNodes(dim, order));
  std::vector<double> shares(std::size_t(dim) * nodes * modes, 0.0), unit(modes);
  const QuadratureRule rule = simplexRule(dim - 1, 1 + order + degree);
  std::array<double, mostFacetNodes> N{};
  for (int q = 0; q < rule.size(); ++q) {
    facetFunctions(dim, order, rule.point(q), N.data());
    basis.values(rule.point(q), unit.data());
    for (int a = 0; a < dim; ++a) {
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

/// What a body feels of a traction: its own order of a facet's vertices, and the opposite sign on the Neumann side.
class FeltShares
{
public:
  FeltShares(const ContactTraction& traction, bool isNeumann)
      : traction_(traction), isNeumann_(isNeumann), inOrder_(traction.dim, traction.degree)
  {}

  /// Adds the shares of facet f in global axes.
  void add(const ContactFacet& facet, std::size_t f, Vector& all)
  {
    const std::size_t modes = traction_.numModes(), dim = std::size_t(facet.dim);
    Vector own(dim * modes);
    for (std::size_t a = 0; a < dim; ++a) {
      const auto vertex = isNeumann_ ? std::size_t(facet.theirs[a]) : a;
      for (std::size_t k = 0; k < modes; ++k)
        for (std::size_t i = 0; i < dim; ++i)
          own[k * dim + i] = component(facet, ((f * dim + vertex) * modes + k), i);
      if (!isNeumann_) {
        all.insert(all.end(), own.begin(), own.end());
        continue;
      }
      const DenseMatrix& modesOf = inOrder_(facet.theirs);
      for (int k = 0; k < int(modes); ++k)
        for (std::size_t i = 0; i < dim; ++i) {
          all.push_back(0.0);
          for (int j = 0; j < int(modes); ++j)
            all.back() -= modesOf(k, j) * own[std::size_t(j) * dim + i];
        }
    }
  }

private:
  double component(const ContactFacet& facet, std::size_t share, std::size_t i) const
  {
    return facet.turns ? traction_.vectors[share * 2 + i] : traction_.shares[share] * facet.normal[i];
  }

  const ContactTraction& traction_;
  bool isNeumann_;
  OrderedModes inOrder_;
};

} // namespace

Direction ContactFacet::normalAt(std::size_t node) const
{
  if (!turns)
    return normal;
  if (node < 2)
    return ends[node];
  return {0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1]), 0.0};
}

std::size_t ContactTraction::numModes() const
{
  return dim == 2 ? std::size_t(degree) + 1 : std::size_t(degree + 1) * std::size_t(degree + 2) / 2;
}

Vector ContactTraction::moments(int facet) const
{
  const std::size_t modes = numModes(), first = std::size_t(facet) * std::size_t(dim) * modes;
  Vector total(modes, 0.0);
  for (std::size_t a = 0; a < std::size_t(dim); ++a)
    for (std::size_t k = 0; k < modes; ++k)
      total[k] += shares[first + a * modes + k];
  return total;
}

DenseMatrix bernsteinOfMoments(int dim, int degree)
{
  const MomentBasis basis = facetBasis(dim, degree);
  const auto powers = bernsteinPowers(dim, degree);
  const int size = basis.size();
  const QuadratureRule rule = simplexRule(dim - 1, 2 * degree);
  DenseMatrix mass(size, size), mixed(size, size);
  Vector B(std::size_t(size), 0.0), L(std::size_t(size), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    bernsteinValues(dim, powers, rule.point(q), B.data());
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

DenseMatrix modesInOrder(int dim, int degree, const std::array<int, 3>& theirs)
{
  constexpr double roundOff = 1e-13;
  const MomentBasis basis = facetBasis(dim, degree);
  const QuadratureRule rule = simplexRule(dim - 1, 2 * degree);
  DenseMatrix R(basis.size(), basis.size());
  Vector ours(std::size_t(basis.size())), other(ours.size());
  for (int q = 0; q < rule.size(); ++q) {
    std::array<double, 3> lambda{};
    for (std::size_t a = 0; a < std::size_t(dim); ++a)
      lambda[a] = rule.point(q)[theirs[a]];
    basis.values(rule.point(q), ours.data());
    basis.values(lambda.data(), other.data());
    for (int k = 0; k < R.rows(); ++k)
      for (int j = 0; j < R.cols(); ++j)
        R(k, j) += rule.weights[std::size_t(q)] * other[std::size_t(k)] * ours[std::size_t(j)];
  }
  for (int k = 0; k < R.rows(); ++k)
    for (int j = 0; j < R.cols(); ++j)
      if (std::abs(R(k, j) - std::round(R(k, j))) < roundOff)
        R(k, j) = std::round(R(k, j));
  return R;
}

const DenseMatrix& OrderedModes::operator()(const std::array<int, 3>& theirs)
{
  const auto found = found_.find(theirs);
  return found != found_.end() ? found->second
                               : found_.emplace(theirs, modesInOrder(dim_, degree_, theirs)).first->second;
}

double largestBernstein(const ContactTraction& traction, const std::vector<ContactFacet>& facets)
{
  const DenseMatrix toBernstein = bernsteinOfMoments(traction.dim, traction.degree);
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
  const int dim = facets.empty() ? 2 : facets.front().dim;
  ContactTraction traction{degree, {}, turnedShares(facets, nodal, order, degree), dim};
  const auto table = nodalShares(dim, order, degree);
  const auto modes = traction.numModes(), nodes = std::size_t(numFacetNodes(dim, order)), vertices = std::size_t(dim);
  traction.shares.assign(facets.size() * vertices * modes, 0.0);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t a = 0; a < vertices; ++a)
      for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t k = 0; k < modes; ++k)
          traction.shares[(f * vertices + a) * modes + k] +=
              facets[f].measure * nodal[std::size_t(facets[f].nodes[i])] * table[(a * nodes + i) * modes + k];
  return traction;
}

std::vector<FacetSide> facetsOfBody(const std::vector<ContactFacet>& facets, int body)
{
  std::vector<FacetSide> ofBody;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const bool isDirichlet : {true, false})
      if (facets[f].body(isDirichlet) == body)
        ofBody.push_back({int(f), isDirichlet});
  return ofBody;
}

Vector contactShares(const std::vector<ContactFacet>& facets, const ContactTraction& onDirichlet,
                     const ContactTraction& onNeumann, int body)
{
  Vector shares;
  FeltShares first(onDirichlet, false), second(onNeumann, true);
  for (const FacetSide& side : facetsOfBody(facets, body))
    (side.isDirichlet ? first : second).add(facets[std::size_t(side.facet)], std::size_t(side.facet), shares);
  return shares;
}

} // namespace ndframe
