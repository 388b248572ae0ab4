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

namespace
{

/// The difference of what both bodies have at a facet's nodes; at(body, node) points to two values.
template <class At>
std::array<Direction, 3> differences(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                                     const At& at)
{
  const auto first = std::size_t(facet.dirichletBody), second = std::size_t(facet.neumannBody);
  const auto ours = contactNodes(*bodies[first], facet, true), theirs = contactNodes(*bodies[second], facet, false);
  std::array<Direction, 3> difference{};
  for (std::size_t i = 0; i <= std::size_t(bodies[first]->nodes.order); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      difference[i][k] = at(first, ours[i])[k] - at(second, theirs[i])[k];
  return difference;
}

} // namespace

std::array<Direction, 3> facetOpening(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                                      const std::vector<Vector>& displacement)
{
  return differences(bodies, facet,
                     [&](std::size_t body, int node) { return displacement[body].data() + std::ptrdiff_t(node) * 2; });
}

std::array<Direction, 3> drawnOpening(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet)
{
  return differences(bodies, facet, [&](std::size_t body, int node) { return bodies[body]->nodes.point(node); });
}

std::array<Direction, 3> closing(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                                 const std::vector<Vector>& displacement)
{
  auto opening = facetOpening(bodies, facet, displacement);
  if (facet.isDrawnApart) {
    const auto drawn = drawnOpening(bodies, facet);
    for (std::size_t i = 0; i <= std::size_t(bodies.front()->nodes.order); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        opening[i][k] += drawn[i][k];
  }
  return opening;
}

} // namespace ndframe
