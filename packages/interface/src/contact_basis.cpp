#include "ndframe/interface/contact_basis.hpp"

#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

/// The ends of a facet's edges, in the order of the nodes in their middles.
std::vector<std::array<int, 2>> edgeEnds(int dim)
{
  if (dim == 2)
    return {SimplexEdges<1>::vertices.begin(), SimplexEdges<1>::vertices.end()};
  return {SimplexEdges<2>::vertices.begin(), SimplexEdges<2>::vertices.end()};
}

} // namespace

ContactBasis::ContactBasis(const std::vector<InterfaceMesh>& interfaces, const std::vector<char>& isNodal)
{
  int first = 0;
  for (const InterfaceMesh& interface : interfaces) {
    for (int i = 0; i < interface.numNodes(); ++i)
      rows_.push_back({{first + i, 1.0}});
    const auto edges = edgeEnds(interface.dim);
    for (int f = 0; interface.order == 2 && f < interface.numFacets(); ++f) {
      const int* nodes = interface.nodesOf(f);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const int middle = first + nodes[interface.dim + int(e)];
        if (!isNodal[std::size_t(middle)])
          rows_[std::size_t(middle)] = {
              {middle, 2.0}, {first + nodes[edges[e][0]], -0.5}, {first + nodes[edges[e][1]], -0.5}};
      }
    }
    first += interface.numNodes();
  }
}

Vector ContactBasis::coefficients(const Vector& values) const
{
  return product(rows_, values);
}

Vector ContactBasis::values(const Vector& coefficients) const
{
  Vector result = coefficients;
  for (const SparseRow& row : rows_) {
    double& value = result[std::size_t(row.front().first)];
    for (std::size_t end = 1; end < row.size(); ++end)
      value -= row[end].second * coefficients[std::size_t(row[end].first)];
    value /= row.front().second;
  }
  return result;
}

Vector ContactBasis::nodalForces(const Vector& forces) const
{
  return transposedProduct(rows_, forces, size());
}

Vector ContactBasis::forces(const Vector& nodalForces) const
{
  Vector result = nodalForces;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].size() > 1) {
      result[i] /= rows_[i].front().second;
      for (std::size_t end = 1; end < rows_[i].size(); ++end)
        result[std::size_t(rows_[i][end].first)] -= rows_[i][end].second * result[i];
    }
  return result;
}

} // namespace ndframe
