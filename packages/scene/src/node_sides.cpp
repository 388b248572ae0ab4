#include "ndframe/scene/model.hpp"

namespace ndframe
{

std::array<NodeSide, 2> Model::sidesAt(const InterfaceMesh& interface, int node) const
{
  const auto i = std::size_t(node);
  std::array<NodeSide, 2> sides{{{interface.dirichlet().body, interface.dirichlet().nodes[i], ContactRole::Dirichlet},
                                 {interface.neumann().body, interface.neumann().nodes[i], ContactRole::Neumann}}};
  if (interface.facesItself(node))
    return sides;
  for (NodeSide& side : sides) {
    const ConstraintSet& set = constraints[std::size_t(side.body)];
    const Direction free = set.freePart(side.node, interface.normals[i]);
    side.isFree = dotProduct(free, free) > 0.0;
    side.held = set.heldValue(side.node, interface.normals[i]);
  }
  return sides;
}

bool Model::carriesContact(const InterfaceMesh& interface, int node) const
{
  const auto sides = sidesAt(interface, node);
  return sides[0].isFree || sides[1].isFree;
}

} // namespace ndframe
