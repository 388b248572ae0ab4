#include "trace_nodes.hpp"

namespace ndframe
{

BodyTraceNodes BodyTraceNodes::without(const std::vector<DependentTrace>& dependents) const
{
  std::vector<char> leaves(traces.size(), 0);
  for (const DependentTrace& dependent : dependents)
    leaves[std::size_t(dependent.given)] = 1;
  BodyTraceNodes rest;
  for (std::size_t i = 0; i < traces.size(); ++i)
    if (!leaves[i]) {
      rest.traces.push_back(traces[i]);
      rest.unknowns.push_back(unknowns[i]);
      rest.onDirichletSide.push_back(onDirichletSide[i]);
      rest.points.push_back(points[i]);
    }
  return rest;
}

std::vector<BodyTraceNodes> numberUnknowns(const Model& model, InterfaceSystem& system)
{
  std::vector<BodyTraceNodes> bodies(model.bodies.size());
  int node = 0;
  for (const auto& interface : model.interfaces)
    for (int i = 0; i < interface.numNodes(); ++i, ++node) {
      if (!model.carriesContact(interface, i))
        continue;
      const auto sides = model.sidesAt(interface, i);
      const bool isObstacle = !sides[0].isFree || !sides[1].isFree;
      double obstacle = 0.0;
      for (const auto& side : sides) {
        if (!side.isFree) { // met by the other one, along its normal
          obstacle = side.isDirichlet ? -side.held : side.held;
          continue;
        }
        auto& b = bodies[std::size_t(side.body)];
        Direction normal = interface.normals[std::size_t(i)];
        for (double& component : normal)
          component = isObstacle && !side.isDirichlet ? -component : component;
        b.traces.push_back({side.node, normal});
        b.unknowns.push_back(system.size());
        b.onDirichletSide.push_back(isObstacle || side.isDirichlet);
        b.points.push_back(interface.pointOf(side.body, i));
      }
      system.nodeOfUnknown.push_back(node);
      system.gap.push_back(interface.gap[std::size_t(i)]);
      system.isObstacle.push_back(isObstacle);
      system.obstacle.push_back(obstacle);
    }
  return bodies;
}

} // namespace ndframe
