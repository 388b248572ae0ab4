#include "ndframe/admissibility/contact_traction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

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

/// What the sides of patches feel of their tractions.
class FeltShares
{
public:
  explicit FeltShares(const SideTractions& tractions)
      : tractions_(tractions), inOrder_(tractions[0].dim, tractions[0].degree)
  {}

  /// Adds the shares of a patch in global axes, in the body's order of vertices.
  void add(const ContactPatch& patch, const BodyPatch& own, Vector& all)
  {
    const std::size_t modes = tractions_[0].numModes(), dim = std::size_t(patch.dim);
    const PatchSide& side = patch.sides[own.side];
    const DenseMatrix& modesOf = inOrder_(side);
    for (std::size_t a = 0; a < patch.numVertices(); ++a) {
      const std::size_t first = tractions_[0].first(own.patch, std::size_t(side.places[a]));
      for (std::size_t k = 0; k < modes; ++k)
        for (std::size_t i = 0; i < dim; ++i) {
          double share = 0.0;
          for (std::size_t j = 0; j < modes; ++j)
            share += modesOf(int(k), int(j)) * component(patch, own.side, first + j, i);
          all.push_back(sideSign(own.side) * share);
        }
    }
  }

private:
  double component(const ContactPatch& patch, std::size_t side, std::size_t share, std::size_t i) const
  {
    const ContactTraction& traction = tractions_[side];
    return patch.turns ? traction.vectors[share * std::size_t(patch.dim) + i]
                       : traction.shares[share] * patch.normal[i];
  }

  const SideTractions& tractions_;
  OrderedModes inOrder_;
};

} // namespace

Vector ContactTraction::moments(int patch) const
{
  const std::size_t modes = numModes();
  Vector total(modes, 0.0);
  for (std::size_t a = 0; a < std::size_t(dim); ++a)
    for (std::size_t k = 0; k < modes; ++k)
      total[k] += shares[first(std::size_t(patch), a) + k];
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

double largestOfMoments(const DenseMatrix& map, const ContactTraction& traction,
                        const std::vector<ContactPatch>& patches)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const Vector values = multiply(map, traction.moments(int(f)));
    largest = std::max(largest, *std::max_element(values.begin(), values.end()) / patches[f].measure);
  }
  return largest;
}

double largestBernstein(const ContactTraction& traction, const std::vector<ContactPatch>& patches)
{
  return largestOfMoments(bernsteinOfMoments(traction.dim, traction.degree), traction, patches);
}

ContactTraction tractionFromNodes(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree)
{
  NDFRAME_ASSERT(order <= degree, "a traction of the displacements' order must fit the degree");
  const int dim = dimOf(patches);
  ContactTraction traction{degree, {}, turnedShares(patches, nodal, order, degree), dim};
  const auto table = nodalShares(dim, order, degree);
  const auto modes = traction.numModes(), nodes = std::size_t(numFacetNodes(dim, order)), vertices = std::size_t(dim);
  traction.shares.assign(traction.first(patches.size(), 0), 0.0);
  for (std::size_t f = 0; f < patches.size(); ++f)
    for (std::size_t a = 0; a < vertices; ++a)
      for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t k = 0; k < modes; ++k)
          traction.shares[traction.first(f, a) + k] +=
              patches[f].measure * nodal[std::size_t(patches[f].nodes[i])] * table[(a * nodes + i) * modes + k];
  return traction;
}

Vector contactShares(const std::vector<ContactPatch>& patches, const SideTractions& tractions, int body)
{
  Vector shares;
  FeltShares felt(tractions);
  for (const BodyPatch& own : patchesOfBody(patches, body))
    felt.add(patches[own.patch], own, shares);
  return shares;
}

} // namespace ndframe
