#include "ndframe/accuracy/first_meshes.hpp"

#include "coarsest_meshes.hpp"

namespace ndframe
{

MeshPlanner readFirstMeshes(Model& model, const RunTools& tools, const AccuracyComponents& components)
{
  const AccuracyOptions& accuracy = *tools.settings.accuracy;
  const bool coarsest = accuracy.start == AccuracyStart::Coarsest;
  readModel(model, tools, coarsest ? coarsestMeshes(tools.deck, components, tools.comm, tools.ledger) : MeshOfBody());
  if (model.bodies.front().mesh.dim == 3)
    throw InputError(accuracy.place.mistake("",
                                            "meshes are adapted in two dimensions only; remove the list and choose the "
                                            "mesh."));
  return {tools.deck, components, model, tools.comm};
}

} // namespace ndframe
