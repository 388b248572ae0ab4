#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks.hpp"

namespace ndframe
{
namespace
{

constexpr int few = 2;
constexpr double pressed = 1e-9; ///< of the largest force of the interface
constexpr std::size_t named = 3; ///< interfaces

void add(std::vector<std::pair<const InterfaceMesh*, std::ptrdiff_t>> touching, const SceneSettings& scene,
         Diagnostics& found)
{
  for (std::size_t i = 0; i < std::min(named, touching.size()); ++i) {
    const auto& [interface, nodes] = touching[i];
    const std::size_t others = i + 1 == named ? touching.size() - named : 0;
    found.add(
        scene.interface(interface->name)
            .place.mistake("", fmt::format("contact is on {} of {} nodes{}: its width and pressure are set by the "
                                           "mesh. Use smaller cells where the bodies touch.",
                                           nodes, interface->numNodes(),
                                           others > 0 ? fmt::format(" (so on {} more interfaces)", others) : "")));
  }
}

} // namespace

/// Contact on one or two nodes is as wide as the mesh makes it: neither its width nor its pressure means anything.
void findFewContactNodes(const Answer& answer, const RunSettings& settings, Diagnostics& found)
{
  const Run& run = answer.run;
  std::vector<std::pair<const InterfaceMesh*, std::ptrdiff_t>> touching;
  std::size_t first = 0;
  for (std::size_t i = 0; i < run.model.interfaces.size(); ++i) {
    const auto& interface = run.model.interfaces[i];
    const auto begin = run.solved.contact.begin() + std::ptrdiff_t(first), end = begin + interface.numNodes();
    double largest = 0.0;
    for (auto node = begin; node != end; ++node)
      largest = std::max(largest, -node->nodalForce);
    const auto nodes = std::count_if(begin, end, [&](const ContactNode& node) {
      return node.closed && largest > 0.0 && -node.nodalForce > pressed * largest;
    });
    if (nodes > 0 && nodes <= few && interface.numNodes() > few)
      touching.emplace_back(&interface, nodes);
    first += std::size_t(interface.numNodes());
  }
  add(touching, settings.scene, found);
}

} // namespace ndframe
