#include "ndframe/accuracy/first_meshes.hpp"

#include "coarsest_meshes.hpp"

namespace ndframe
{

MeshPlanner readFirstMeshes(Model& model, const RunTools& tools, const AccuracyComponents& components)
{
  const AccuracyOptions& accuracy = *tools.settings.accuracy;
  const bool coarsest = accuracy.start == AccuracyStart::Coarsest;
  readModel(model, tools, coarsest ? coarsestMeshes(tools.deck, components, tools.comm, tools.ledger) : MeshOfBody());
  return {tools.deck, components, model, tools.comm};
}

} // namespace ndframe
