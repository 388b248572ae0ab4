#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{

/// Parts of a mesh that share no facet are bodies of their own: nothing is carried from one to the other.
void findUnconnectedParts(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  if (model.isOuter()) // those who have the rest have seen that it is one part
    return;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    if (body.isRigid)
      continue;
    const Mesh& mesh = body.mesh;
    int count = 0;
    const std::vector<int> parts = connectedParts(mesh, count);
    if (count < 2)
      continue;
    const auto cell = int(std::find(parts.begin(), parts.end(), 1) - parts.begin());
    found.add(scene.bodies[b].place.mistake(
        "", fmt::format("its mesh has {} parts that share no {}; one of them is at {}. Nothing connects them: merge "
                        "their points, or make them bodies with an interface.",
                        count, mesh.dim == 2 ? "edge" : "face", pointText(cellCentre(mesh, cell).data(), mesh.dim))));
  }
}

} // namespace ndframe
