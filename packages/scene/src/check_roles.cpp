#include <set>

#include <fmt/format.h>

#include "ndframe/scene/model.hpp"

namespace ndframe
{

void checkRoles(const Params& deck, Diagnostics& diagnostics)
{
  std::set<std::string> dirichlet;
  for (const auto& interface : deck.sub("Interfaces").subs())
    dirichlet.insert(interface.get<std::string>("Dirichlet Body"));
  for (const auto& interface : deck.sub("Interfaces").subs()) {
    const auto name = interface.get<std::string>("Neumann Body");
    if (dirichlet.count(name) > 0 && name != interface.get<std::string>("Dirichlet Body"))
      diagnostics.add(interface.mistake(
          "Neumann Body",
          fmt::format("\"{}\" is the Dirichlet body of another interface; Neumann-Dirichlet solves a body "
                      "in one role: exchange the roles here, or use Coupling/Dirichlet Body = Automatic or "
                      "Coupling/Type = Monolithic.",
                      name)));
  }
}

} // namespace ndframe
