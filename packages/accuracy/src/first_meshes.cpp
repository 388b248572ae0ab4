#include "ndframe/accuracy/first_meshes.hpp"

#include "coarsest_meshes.hpp"

namespace ndframe
{

MeshPlanner readFirstMeshes(Model& model, const RunTools& tools, const AccuracyComponents& components)
{
  const AccuracyOptions& accuracy = *tools.settings.accuracy;
  const bool coarsest = accuracy.start == AccuracyStart::Coarsest;
  readModel(model, tools,
            coarsest ? coarsestMeshes(tools.settings.scene, components, tools.comm, tools.ledger) : MeshOfBody());
  return {tools.settings, components, model, tools.comm};
}

} // namespace ndframe
