#include "node_stiffness.hpp"

#include <algorithm>

#include "ndframe/mechanics/kernels.hpp"
#include "ndframe/recovery/contact_nodes.hpp"

namespace ndframe
{
namespace
{

template <int order>
void addCells(const BodyModel& body, NodeStiffness& blocks)
{
  constexpr int nodes = Lagrange<2, order>::nodes, dofs = 2 * nodes;
  const QuadratureRule rule = simplexRule(2, 2 * (order - 1));
  double points[6], element[dofs * dofs];
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const int* cellNodes = body.nodes.cell(cell);
    if (std::none_of(cellNodes, cellNodes + nodes, [&](int node) { return blocks.count(node) > 0; }))
      continue;
    for (int v = 0; v < 3; ++v)
      std::copy_n(body.mesh.point(body.mesh.cell(cell)[v]), 2, points + v * 2);
    elementStiffness<2, order>(points, body.law, rule, element);
    for (int a = 0; a < nodes; ++a)
      if (const auto found = blocks.find(cellNodes[a]); found != blocks.end())
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            found->second.K[std::size_t(i * 2 + j)] += element[(a * 2 + i) * dofs + a * 2 + j];
  }
}

} // namespace

NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactFacet>& facets, int bodyNumber)
{
  NodeStiffness blocks;
  for (const ContactFacet& facet : facets)
    for (const bool isDirichlet : {true, false})
      if ((isDirichlet ? facet.dirichletBody : facet.neumannBody) == bodyNumber) {
        const auto nodes = contactNodes(body, facet, isDirichlet);
        for (std::size_t i = 0; i <= std::size_t(body.nodes.order); ++i)
          blocks[nodes[i]];
      }
  body.nodes.order == 1 ? addCells<1>(body, blocks) : addCells<2>(body, blocks);
  return blocks;
}

} // namespace ndframe
