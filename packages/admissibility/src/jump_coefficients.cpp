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

/// In the plane, where n_c turns: the node of a coefficient of the displacements' order, ascending along the edge.
std::size_t nodeAlong(int order, std::size_t k)
{
  return order == 1 || k == 0 ? k : 3 - k;
}

double weightAlong(int order, std::size_t k, std::size_t node)
{
  return bernsteinWeight(2, order, int(nodeAlong(order, k)), int(node));
}

} // namespace

Direction JumpCoefficients::weight(std::size_t k, std::size_t node) const
{
  if (!patch.turns)
    return scaled(bernsteinWeight(patch.dim, order, int(k), int(node)), patch.normal);
  // n has degree one: the product's coefficient k takes k parts of n_1 and the rest of n_0
  const double degree = order + 1, part = double(k) / degree;
  Direction result{};
  if (k <= std::size_t(order))
    result = scaled((1.0 - part) * weightAlong(order, k, node), patch.ends[0]);
  if (k > 0)
    result = sum(result, scaled(part * weightAlong(order, k - 1, node), patch.ends[1]));
  return result;
}

std::size_t JumpCoefficients::size() const
{
  return patch.numNodes(order) + (patch.turns ? 1 : 0);
}

std::size_t JumpCoefficients::atVertex(std::size_t vertex) const
{
  return patch.turns && vertex == 1 ? size() - 1 : vertex;
}

std::vector<std::size_t> JumpCoefficients::atMiddle(std::size_t node) const
{
  if (!patch.turns)
    return {node};
  std::vector<std::size_t> inner(size() - 2);
  std::iota(inner.begin(), inner.end(), 1);
  return inner;
}

double JumpCoefficients::of(std::size_t k, const PatchVectors& opening) const
{
  if (patch.turns) {
    double value = 0.0;
    for (std::size_t node = 0; node <= std::size_t(order); ++node)
      value += dotProduct(weight(k, node), opening[node]);
    return value;
  }
  const auto along = [&](std::size_t node) { return dotProduct(patch.normal, opening[node]); };
  const std::size_t vertices = patch.numVertices();
  if (k < vertices)
    return along(k);
  const auto& ends = facetEdges(patch.dim).ends[k - vertices];
  return 2.0 * along(k) - 0.5 * (along(std::size_t(ends[0])) + along(std::size_t(ends[1])));
}

double JumpCoefficients::gap(std::size_t k, const double* bernstein) const
{
  if (!patch.turns)
    return bernstein[k];
  const double part = double(k) / (order + 1);
  return (k <= std::size_t(order) ? (1.0 - part) * bernstein[nodeAlong(order, k)] : 0.0) +
         (k > 0 ? part * bernstein[nodeAlong(order, k - 1)] : 0.0);
}

} // namespace ndframe
