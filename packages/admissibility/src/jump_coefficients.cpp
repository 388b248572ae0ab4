#include "ndframe/admissibility/jump_coefficients.hpp"

#include <numeric>

namespace ndframe
{
namespace
{

Direction scaled(double factor, const Direction& d)
{
  return {factor * d[0], factor * d[1], factor * d[2]};
}

Direction sum(const Direction& a, const Direction& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The node that a coefficient of the displacements' order belongs to: on edges the middle is the last node.
std::size_t nodeOf(int dim, int order, std::size_t k)
{
  return dim == 3 || order == 1 || k == 0 ? k : 3 - k;
}

double nodalWeight(int dim, int order, std::size_t k, std::size_t node)
{
  return bernsteinWeight(dim, order, int(nodeOf(dim, order, k)), int(node));
}

} // namespace

Direction JumpCoefficients::weight(std::size_t k, std::size_t node) const
{
  if (!facet.turns)
    return scaled(nodalWeight(facet.dim, order, k, node), facet.normal);
  // n has degree one: the product's coefficient k takes k parts of n_1 and the rest of n_0
  const double degree = order + 1, part = double(k) / degree;
  Direction result{};
  if (k <= std::size_t(order))
    result = scaled((1.0 - part) * nodalWeight(2, order, k, node), facet.ends[0]);
  if (k > 0)
    result = sum(result, scaled(part * nodalWeight(2, order, k - 1, node), facet.ends[1]));
  return result;
}

std::size_t JumpCoefficients::size() const
{
  return std::size_t(numFacetNodes(facet.dim, order)) + (facet.turns ? 1 : 0);
}

std::size_t JumpCoefficients::atVertex(std::size_t vertex) const
{
  return facet.dim == 2 && vertex == 1 ? size() - 1 : vertex;
}

std::vector<std::size_t> JumpCoefficients::atMiddle(std::size_t node) const
{
  if (facet.dim == 3)
    return {node};
  std::vector<std::size_t> inner(size() - 2);
  std::iota(inner.begin(), inner.end(), 1);
  return inner;
}

double JumpCoefficients::of(std::size_t k, const FacetVectors& opening) const
{
  if (facet.turns) {
    double value = 0.0;
    for (std::size_t node = 0; node <= std::size_t(order); ++node)
      value += dotProduct(weight(k, node), opening[node]);
    return value;
  }
  const auto along = [&](std::size_t node) { return dotProduct(facet.normal, opening[node]); };
  const auto vertices = std::size_t(facet.dim);
  const std::size_t node = nodeOf(facet.dim, order, k);
  if (node < vertices)
    return along(node);
  const auto& ends = facetEdges(facet.dim).ends[node - vertices];
  return 2.0 * along(node) - 0.5 * (along(std::size_t(ends[0])) + along(std::size_t(ends[1])));
}

double JumpCoefficients::gap(std::size_t k, const double* bernstein) const
{
  if (!facet.turns)
    return bernstein[k];
  const double part = double(k) / (order + 1);
  return (k <= std::size_t(order) ? (1.0 - part) * bernstein[k] : 0.0) + (k > 0 ? part * bernstein[k - 1] : 0.0);
}

} // namespace ndframe
