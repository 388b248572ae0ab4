#include "odd_ring.hpp"

#include <fmt/format.h>

#include "ndframe/coupling/odd_cycle.hpp"

namespace ndframe
{

std::string oddRing(const Model& model)
{
  std::vector<std::pair<int, int>> neighbours;
  for (const auto& interface : model.interfaces)
    neighbours.emplace_back(interface.dirichlet().body, interface.neumann().body);
  const std::vector<int> ring = oddCycle(int(model.bodies.size()), neighbours);
  if (ring.empty())
    return {};
  if (ring.size() == 1)
    return fmt::format("\"{}\" touches itself and would have both roles, which Neumann-Dirichlet cannot solve; use "
                       "Coupling/Type = Monolithic or FETI.",
                       model.bodies[std::size_t(ring.front())].name);
  std::string names;
  for (const int body : ring)
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", model.bodies[std::size_t(body)].name);
  return fmt::format(
      "{} touch each other in a ring of {} bodies: with an odd number two neighbours would have the same "
      "role, which Neumann-Dirichlet cannot solve; use Coupling/Type = Monolithic or FETI.",
      names, ring.size());
}

} // namespace ndframe
