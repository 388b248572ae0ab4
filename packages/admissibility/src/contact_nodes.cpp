#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

std::array<int, 3> contactNodes(const BodyModel& body, const ContactFacet& facet, bool isDirichlet)
{
  std::array<int, 3> nodes{};
  facetNodes(body.nodes, isDirichlet ? facet.dirichlet : facet.neumann, nodes.data());
  if ((nodes[0] > nodes[1]) != (!isDirichlet && facet.reversed))
    std::swap(nodes[0], nodes[1]);
  return nodes;
}

std::array<Direction, 3> facetOpening(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                                      const std::vector<Vector>& displacement)
{
  const auto first = std::size_t(facet.dirichletBody), second = std::size_t(facet.neumannBody);
  const auto ours = contactNodes(*bodies[first], facet, true), theirs = contactNodes(*bodies[second], facet, false);
  std::array<Direction, 3> opening{};
  for (std::size_t i = 0; i <= std::size_t(bodies[first]->nodes.order); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      opening[i][k] =
          displacement[first][std::size_t(ours[i]) * 2 + k] - displacement[second][std::size_t(theirs[i]) * 2 + k];
  return opening;
}

std::array<Direction, 3> closing(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                                 const std::vector<Vector>& displacement)
{
  auto opening = facetOpening(bodies, facet, displacement);
  for (std::size_t i = 0; facet.isDrawnApart && i < opening.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      opening[i][k] += facet.drawn[i][k];
  return opening;
}

} // namespace ndframe
