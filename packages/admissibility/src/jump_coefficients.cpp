#include "ndframe/admissibility/jump_coefficients.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// How a coefficient of the product n . (u1 - u2) follows from n at a vertex and a coefficient of u1 - u2.
struct ProductTerm
{
  std::size_t vertex;
  int coefficient; ///< in the order of the nodes
  double share;
};

/// The Bernstein coefficients of the product of a linear function and one of the displacements' order.
struct ProductTable
{
  std::vector<std::array<int, 3>> powers;
  std::vector<std::vector<ProductTerm>> terms; ///< per coefficient
};

/// The coefficient with these exponents, which add up to the order, in the order of the nodes.
int coefficientOf(int dim, const std::array<int, 3>& powers)
{
  std::vector<int> vertices;
  for (int a = 0; a < dim; ++a)
    if (powers[std::size_t(a)] > 0)
      vertices.push_back(a);
  if (vertices.size() == 1)
    return vertices.front();
  const FacetEdges edges = facetEdges(dim);
  const auto* edge = std::find_if(edges.ends, edges.ends + edges.size, [&](const std::array<int, 2>& ends) {
    return std::minmax(ends[0], ends[1]) == std::minmax(vertices[0], vertices[1]);
  });
  return dim + int(edge - edges.ends);
}

ProductTable makeTable(int dim, int order)
{
  ProductTable table{bernsteinPowers(dim, order + 1), {}};
  for (const auto& powers : table.powers) {
    table.terms.emplace_back();
    for (std::size_t e = 0; e < std::size_t(dim); ++e)
      if (auto less = powers; less[e]-- > 0)
        table.terms.back().push_back({e, coefficientOf(dim, less), double(powers[e]) / (order + 1)});
  }
  return table;
}

const ProductTable& tableFor(int dim, int order)
{
  static const std::array<ProductTable, 4> tables{makeTable(2, 1), makeTable(2, 2), makeTable(3, 1), makeTable(3, 2)};
  return tables[std::size_t(dim - 2) * 2 + std::size_t(order - 1)];
}

} // namespace

Direction JumpCoefficients::weight(std::size_t k, std::size_t node) const
{
  Direction result{};
  const auto add = [&](double share, int coefficient, const Direction& normal) {
    const double factor = share * bernsteinWeight(patch.dim, order, coefficient, int(node));
    for (std::size_t i = 0; i < 3; ++i)
      result[i] += factor * normal[i];
  };
  if (!patch.turns)
    add(1.0, int(k), patch.normal);
  else
    for (const ProductTerm& term : tableFor(patch.dim, order).terms[k])
      add(term.share, term.coefficient, patch.ends[term.vertex]);
  return result;
}

std::size_t JumpCoefficients::size() const
{
  return patch.turns ? tableFor(patch.dim, order).powers.size() : patch.numNodes(order);
}

std::size_t JumpCoefficients::atVertex(std::size_t vertex) const
{
  if (!patch.turns)
    return vertex;
  const auto& powers = tableFor(patch.dim, order).powers;
  return std::size_t(
      std::find_if(powers.begin(), powers.end(), [&](const auto& of) { return of[vertex] == order + 1; }) -
      powers.begin());
}

std::vector<std::size_t> JumpCoefficients::alongEdge(std::size_t edge, bool inside) const
{
  const auto [a, b] = facetEdges(patch.dim).ends[edge];
  const auto& powers = tableFor(patch.dim, order).powers;
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < powers.size(); ++k)
    if (const int along = powers[k][std::size_t(a)] + powers[k][std::size_t(b)];
        powers[k][std::size_t(a)] > 0 && powers[k][std::size_t(b)] > 0 && (inside || along == order + 1))
      found.push_back(k);
  return found;
}

std::vector<std::size_t> JumpCoefficients::atMiddle(std::size_t node) const
{
  if (!patch.turns)
    return {node};
  return alongEdge(node - patch.numVertices(), true);
}

double JumpCoefficients::of(std::size_t k, const PatchVectors& opening) const
{
  double value = 0.0;
  for (std::size_t node = 0; node < patch.numNodes(order); ++node)
    value += dotProduct(weight(k, node), opening[node]);
  return value;
}

double JumpCoefficients::gap(std::size_t k, const double* bernstein) const
{
  if (!patch.turns)
    return bernstein[k];
  double value = 0.0;
  for (const ProductTerm& term : tableFor(patch.dim, order).terms[k])
    value += term.share * bernstein[term.coefficient];
  return value;
}

} // namespace ndframe
