#include "ndframe/scene/read_meshes.hpp"

#include <algorithm>

#include "ndframe/scene/shared_mesh.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{

void updateMeshes(Model& model, const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                  Ledger& ledger)
{
  const SceneRecipe recipe = recipeOf(scene);
  const auto sameMesh = [](const BodyRecipe& a, const BodyRecipe& b) { return a.mesh == b.mesh; };
  const auto &now = recipe.bodies, &before = model.recipe.bodies;
  if (std::equal(now.begin(), now.end(), before.begin(), before.end(), sameMesh))
    return;
  const auto timer = timeStage(ledger, Stage::Read);
  Model read;
  ScriptMeshes scripts(ledger);
  for (std::size_t b = 0; b < now.size(); ++b) {
    const BodySettings& body = scene.bodies[b];
    const bool isKnown = now.size() == before.size() && sameMesh(now[b], before[b]);
    read.bodies.emplace_back();
    read.bodies.back().name = body.name;
    if (!body.isRigid) {
      GivenMesh given = isKnown ? GivenMesh(model.bodies[b].uncut(), {}, model.bodies[b].drawn)
                                : readShared(*components.meshSources.build(body.shape), comm, scripts);
      read.bodies.back().mesh = std::move(given.mesh);
      read.bodies.back().drawn = std::move(given.drawn);
    }
    read.recipe.bodies.push_back({now[b].name, now[b].mesh, {}, {}});
  }
  model = std::move(read);
}

} // namespace ndframe
