#include <set>

#include <fmt/format.h>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

void checkRoles(const SceneSettings& scene, Diagnostics& diagnostics)
{
  std::set<std::string> dirichlet;
  for (const InterfaceSettings& interface : scene.interfaces)
    dirichlet.insert(interface.dirichletBody);
  for (const InterfaceSettings& interface : scene.interfaces) {
    const std::string& name = interface.neumannBody;
    if (dirichlet.count(name) > 0 && name != interface.dirichletBody)
      diagnostics.add(interface.place.mistake(
          "Neumann Body",
          fmt::format("\"{}\" is the Dirichlet body of another interface; Neumann-Dirichlet solves a body "
                      "in one role: exchange the roles here, or use Coupling/Dirichlet Body = Automatic or "
                      "Coupling/Type = Monolithic.",
                      name)));
  }
}

} // namespace ndframe
