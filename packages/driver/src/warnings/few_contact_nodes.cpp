#include <fmt/format.h>

#include "checks.hpp"

namespace ndframe
{
namespace
{

constexpr int few = 2;
constexpr double pressed = 1e-9; ///< of the largest force of the interface

} // namespace

/// Contact on one or two nodes is as wide as the mesh makes it: neither its width nor its pressure means anything.
void findFewContactNodes(const Run& run, const Params& deck, Diagnostics& found)
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < run.model.interfaces.size(); ++i) {
    const auto& interface = run.model.interfaces[i];
    const auto begin = run.contact.begin() + std::ptrdiff_t(first), end = begin + interface.numNodes();
    double largest = 0.0;
    for (auto node = begin; node != end; ++node)
      largest = std::max(largest, -node->nodalForce);
    const auto nodes = std::count_if(begin, end, [&](const ContactNode& node) {
      return node.closed && largest > 0.0 && -node.nodalForce > pressed * largest;
    });
    if (nodes > 0 && nodes <= few && interface.numNodes() > few)
      found.add(
          deck.sub("Interfaces")
              .sub(interface.name)
              .mistake(
                  "",
                  fmt::format("contact is on {} of {} nodes: its width and pressure are those of the mesh. Use smaller "
                              "cells where the bodies touch.",
                              nodes, interface.numNodes())));
    first += std::size_t(interface.numNodes());
  }
}

} // namespace ndframe
