#include "node_stiffness.hpp"

#include <algorithm>
#include <set>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

template <int order>
NodeStiffness blocksBetween(const BodyModel& body, const std::set<int>& chosen)
{
  constexpr int nodes = Lagrange<2, order>::nodes, dofs = 2 * nodes;
  const QuadratureRule rule = simplexRule(2, 2 * (order - 1));
  const auto isChosen = [&](int node) { return chosen.count(node) > 0; };
  NodeStiffness blocks;
  double points[6], element[dofs * dofs];
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const int* cellNodes = body.nodes.cell(cell);
    if (std::none_of(cellNodes, cellNodes + nodes, isChosen))
      continue;
    cellPoints(body.mesh, cell, points);
    elementStiffness<2, order>(points, body.laws(cell), rule, element);
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b) {
        if (!isChosen(cellNodes[a]) || !isChosen(cellNodes[b]))
          continue;
        NodeBlock& block = blocks[{cellNodes[a], cellNodes[b]}];
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            block.K[std::size_t(i) * 2 + std::size_t(j)] += element[(a * 2 + i) * dofs + b * 2 + j];
      }
  }
  return blocks;
}

} // namespace

NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactFacet>& facets, int bodyNumber)
{
  std::set<int> chosen;
  for (const ContactFacet& facet : facets)
    for (const bool isDirichlet : {true, false})
      if ((isDirichlet ? facet.dirichletBody : facet.neumannBody) == bodyNumber) {
        const auto nodes = contactNodes(body, facet, isDirichlet);
        chosen.insert(nodes.begin(), nodes.begin() + body.nodes.order + 1);
      }
  return body.nodes.order == 1 ? blocksBetween<1>(body, chosen) : blocksBetween<2>(body, chosen);
}

} // namespace ndframe
