#include "node_stiffness.hpp"

#include <algorithm>
#include <set>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

template <int dim, int order>
NodeStiffness blocksBetween(const BodyModel& body, const std::set<int>& chosen)
{
  constexpr int nodes = Lagrange<dim, order>::nodes, dofs = dim * nodes;
  const QuadratureRule rule = simplexRule(dim, 2 * (order - 1));
  const auto isChosen = [&](int node) { return chosen.count(node) > 0; };
  NodeStiffness blocks;
  double points[dim * (dim + 1)], element[dofs * dofs];
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const int* cellNodes = body.nodes.cell(cell);
    if (std::none_of(cellNodes, cellNodes + nodes, isChosen))
      continue;
    cellPoints(body.mesh, cell, points);
    elementStiffness<dim, order>(points, body.laws(cell), rule, element);
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b) {
        if (!isChosen(cellNodes[a]) || !isChosen(cellNodes[b]))
          continue;
        NodeBlock& block = blocks[{cellNodes[a], cellNodes[b]}];
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            block.K[std::size_t(i) * 3 + std::size_t(j)] += element[(a * dim + i) * dofs + b * dim + j];
      }
  }
  return blocks;
}

} // namespace

NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactPatch>& patches, int bodyNumber)
{
  std::set<int> chosen;
  for (const BodyPatch& own : patchesOfBody(patches, bodyNumber)) {
    const auto nodes = contactNodes(body, patches[own.patch].sides[own.side]);
    chosen.insert(nodes.begin(), nodes.begin() + body.nodes.nodesPerFacet);
  }
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto dim, auto order) { return blocksBetween<dim(), order()>(body, chosen); });
}

} // namespace ndframe
