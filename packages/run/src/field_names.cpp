#include "field_names.hpp"

#include <fmt/format.h>

namespace ndframe
{

void checkFieldNames(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  constexpr std::size_t longest = 256; // of netCDF
  const auto check = [&](const ListPlace& list, const std::string& name) {
    if (name.size() > longest)
      diagnostics.add(list.mistake("", fmt::format("its name makes names of {} characters in the Exodus file, which "
                                                   "allows {}; shorten it, or set Output/Exodus = false.",
                                                   name.size(), longest)));
  };
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    std::string side;
    for (const auto& candidate : body.mesh.sides)
      side = candidate.name.size() > side.size() ? candidate.name : side;
    check(scene.bodies[b].place, body.name + ":" + side);
  }
  for (const auto& interface : model.interfaces)
    check(scene.interface(interface.name).place, interface.name + ":dirichlet");
}

} // namespace ndframe
