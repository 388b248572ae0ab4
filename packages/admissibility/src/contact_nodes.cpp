#include "ndframe/admissibility/contact_nodes.hpp"

#include <algorithm>

namespace ndframe
{

FacetNodes contactNodes(const BodyModel& body, const PatchSide& side)
{
  FacetNodes own{}, nodes{};
  facetNodes(body.nodes, side.facet, own.data());
  const int dim = body.mesh.dim;
  const auto vertices = std::size_t(dim);
  const std::array<int, 3> ascending = ascendingPlaces(dim, own.data());
  std::array<int, 3> place{}; // where the patch's vertices stand in `own`
  for (std::size_t a = 0; a < vertices; ++a)
    place[std::size_t(side.places[a])] = ascending[a];
  for (std::size_t a = 0; a < vertices; ++a)
    nodes[a] = own[std::size_t(place[a])];
  const FacetEdges edges = facetEdges(dim);
  for (int e = 0; body.nodes.order == 2 && e < edges.size; ++e)
    for (int other = 0; other < edges.size; ++other) { // the edge of `own` with the same ends
      const auto [a, b] = edges.ends[other];
      const int first = place[std::size_t(edges.ends[e][0])], second = place[std::size_t(edges.ends[e][1])];
      if (std::minmax(a, b) == std::minmax(first, second))
        nodes[vertices + std::size_t(e)] = own[vertices + std::size_t(other)];
    }
  return nodes;
}

PatchVectors patchOpening(const std::vector<const BodyModel*>& bodies, const ContactPatch& patch,
                          const std::vector<NodalField>& displacement)
{
  const auto dim = std::size_t(patch.dim);
  PatchVectors opening{};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto b = std::size_t(patch.sides[side].body);
    const FacetNodes nodes = contactNodes(*bodies[b], patch.sides[side]);
    for (std::size_t i = 0; i < patch.numNodes(bodies[b]->nodes.order); ++i)
      for (std::size_t k = 0; k < dim; ++k)
        opening[i][k] += sideSign(side) * displacement[b][std::size_t(nodes[i]) * dim + k];
  }
  return opening;
}

PatchVectors closing(const std::vector<const BodyModel*>& bodies, const ContactPatch& patch,
                     const std::vector<NodalField>& displacement)
{
  auto opening = patchOpening(bodies, patch, displacement);
  for (std::size_t i = 0; patch.isDrawnApart && i < patch.drawn.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      opening[i][k] += patch.drawn[i][k];
  return opening;
}

} // namespace ndframe
