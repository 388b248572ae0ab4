#include "ndframe/admissibility/jump_coefficients.hpp"

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

/// Bernstein coefficient k of a polynomial of order 1 or 2 by its values at the nodes of an edge.
double nodalWeight(int order, std::size_t k, std::size_t node)
{
  if (order == 2 && k == 1)
    return node == 2 ? 2.0 : -0.5;
  return node == (k == 0 ? 0u : 1u) ? 1.0 : 0.0;
}

} // namespace

Direction JumpCoefficients::weight(std::size_t k, std::size_t node) const
{
  if (!facet.turns)
    return scaled(nodalWeight(order, k, node), facet.normal);
  // n has degree one: the product's coefficient k takes k parts of n_1 and the rest of n_0
  const double degree = order + 1, part = double(k) / degree;
  Direction result{};
  if (k <= std::size_t(order))
    result = scaled((1.0 - part) * nodalWeight(order, k, node), facet.ends[0]);
  if (k > 0)
    result = sum(result, scaled(part * nodalWeight(order, k - 1, node), facet.ends[1]));
  return result;
}

double JumpCoefficients::of(std::size_t k, const std::array<Direction, 3>& opening) const
{
  if (facet.turns) {
    double value = 0.0;
    for (std::size_t node = 0; node <= std::size_t(order); ++node)
      value += dotProduct(weight(k, node), opening[node]);
    return value;
  }
  const auto along = [&](std::size_t node) { return dotProduct(facet.normal, opening[node]); };
  if (order == 2 && k == 1)
    return 2.0 * along(2) - 0.5 * (along(0) + along(1));
  return along(k == 0 ? 0 : 1);
}

double JumpCoefficients::gap(std::size_t k, const double* bernstein) const
{
  if (!facet.turns)
    return bernstein[k];
  const double part = double(k) / (order + 1);
  return (k <= std::size_t(order) ? (1.0 - part) * bernstein[k] : 0.0) + (k > 0 ? part * bernstein[k - 1] : 0.0);
}

} // namespace ndframe
