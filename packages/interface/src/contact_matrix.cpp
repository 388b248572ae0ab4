#include "ndframe/interface/contact_matrix.hpp"

#include <cmath>
#include <map>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// int N_a N_b over a facet of measure 1, row-major.
template <int facetDim, int order>
std::vector<double> facetMass()
{
  constexpr int nodes = Lagrange<facetDim, order>::nodes;
  const auto rule = simplexRule(facetDim, 2 * order);
  std::vector<double> mass(std::size_t(nodes) * std::size_t(nodes), 0.0);
  double N[nodes];
  for (int q = 0; q < rule.size(); ++q) {
    Lagrange<facetDim, order>::values(rule.point(q), N);
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b)
        mass[std::size_t(a) * std::size_t(nodes) + std::size_t(b)] += rule.weights[std::size_t(q)] * N[a] * N[b];
  }
  return mass;
}

} // namespace

ContactMatrix::ContactMatrix(const std::vector<InterfaceMesh>& interfaces)
{
  int total = 0;
  for (const auto& interface : interfaces)
    total += interface.numNodes();
  std::vector<std::map<int, double>> rows(static_cast<std::size_t>(total));
  int offset = 0;
  for (const auto& interface : interfaces) {
    const auto mass =
        withDimAndOrder(interface.dim, interface.order, [](auto d, auto p) { return facetMass<d() - 1, p()>(); });
    const int nodes = interface.nodesPerFacet();
    for (int f = 0; f < interface.numFacets(); ++f)
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          rows[std::size_t(offset) + std::size_t(interface.nodesOf(f)[a])][offset + interface.nodesOf(f)[b]] +=
              interface.measures[std::size_t(f)] * mass[std::size_t(a) * std::size_t(nodes) + std::size_t(b)];
    offset += interface.numNodes();
  }
  rowPtr_.push_back(0);
  for (int i = 0; i < total; ++i) {
    for (const auto& [column, value] : rows[std::size_t(i)]) {
      cols_.push_back(column);
      values_.push_back(value);
    }
    rowPtr_.push_back(int(cols_.size()));
    diagonal_.push_back(rows[std::size_t(i)].at(i));
  }
}

SparseRow ContactMatrix::row(int node) const
{
  SparseRow entries;
  for (int k = rowPtr_[std::size_t(node)]; k < rowPtr_[std::size_t(node) + 1]; ++k)
    entries.emplace_back(cols_[std::size_t(k)], values_[std::size_t(k)]);
  return entries;
}

Vector ContactMatrix::apply(const Vector& traction) const
{
  Vector force(traction.size(), 0.0);
  for (std::size_t i = 0; i < force.size(); ++i)
    for (int k = rowPtr_[i]; k < rowPtr_[i + 1]; ++k)
      force[i] += values_[std::size_t(k)] * traction[std::size_t(cols_[std::size_t(k)])];
  return force;
}

Vector ContactMatrix::solve(const Vector& nodalForce) const
{
  constexpr int mostIterations = 400;
  constexpr double tolerance = 1e-16;
  const std::size_t n = nodalForce.size();
  Vector x(n, 0.0), r = nodalForce, z(n), p(n, 0.0);
  double previous = 1.0, start = -1.0;
  for (int iteration = 0; iteration < mostIterations; ++iteration) {
    for (std::size_t i = 0; i < n; ++i)
      z[i] = r[i] / diagonal_[i];
    const double rz = dot(r, z);
    if (start < 0.0)
      start = rz;
    if (rz <= tolerance * tolerance * start)
      return x;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = z[i] + (iteration == 0 ? 0.0 : rz / previous) * p[i];
    previous = rz;
    const Vector Cp = apply(p);
    const double step = rz / dot(p, Cp);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += step * p[i];
      r[i] -= step * Cp[i];
    }
  }
  throw InternalError("the contact matrix is not a mass matrix: conjugate gradients did not converge");
}

} // namespace ndframe
