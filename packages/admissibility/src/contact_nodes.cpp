#include "ndframe/admissibility/contact_nodes.hpp"

#include <algorithm>

namespace ndframe
{

FacetNodes contactNodes(const BodyModel& body, const ContactFacet& facet, bool isDirichlet)
{
  FacetNodes own{}, nodes{};
  facetNodes(body.nodes, isDirichlet ? facet.dirichlet : facet.neumann, own.data());
  const auto vertices = std::size_t(facet.dim);
  const std::array<int, 3> ascending = ascendingPlaces(facet.dim, own.data());
  std::array<int, 3> place{}; // where our vertices stand in `own`
  for (std::size_t a = 0; a < vertices; ++a)
    place[isDirichlet ? a : std::size_t(facet.theirs[a])] = ascending[a];
  for (std::size_t a = 0; a < vertices; ++a)
    nodes[a] = own[std::size_t(place[a])];
  const FacetEdges edges = facetEdges(facet.dim);
  for (int e = 0; body.nodes.order == 2 && e < edges.size; ++e)
    for (int other = 0; other < edges.size; ++other) { // the edge of `own` with the same ends
      const auto [a, b] = edges.ends[other];
      const int first = place[std::size_t(edges.ends[e][0])], second = place[std::size_t(edges.ends[e][1])];
      if (std::minmax(a, b) == std::minmax(first, second))
        nodes[vertices + std::size_t(e)] = own[vertices + std::size_t(other)];
    }
  return nodes;
}

FacetVectors facetOpening(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                          const std::vector<Vector>& displacement)
{
  const auto first = std::size_t(facet.dirichletBody), second = std::size_t(facet.neumannBody);
  const auto ours = contactNodes(*bodies[first], facet, true), theirs = contactNodes(*bodies[second], facet, false);
  const auto dim = std::size_t(facet.dim);
  FacetVectors opening{};
  for (std::size_t i = 0; i < std::size_t(bodies[first]->nodes.nodesPerFacet); ++i)
    for (std::size_t k = 0; k < dim; ++k)
      opening[i][k] =
          displacement[first][std::size_t(ours[i]) * dim + k] - displacement[second][std::size_t(theirs[i]) * dim + k];
  return opening;
}

FacetVectors closing(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                     const std::vector<Vector>& displacement)
{
  auto opening = facetOpening(bodies, facet, displacement);
  for (std::size_t i = 0; facet.isDrawnApart && i < facet.drawn.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      opening[i][k] += facet.drawn[i][k];
  return opening;
}

} // namespace ndframe
