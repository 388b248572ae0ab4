#include "ndframe/run/contact_ends.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "ndframe/run/interface_chains.hpp"

namespace ndframe
{
namespace
{

/// Pressing forces and gaps below this part of the largest one are round-off.
constexpr double roundOff = 1e-9;

/// The nodes of a plane interface with their neighbours along it.
class Chain
{
public:
  Chain(const InterfaceMesh& interface, const ContactNode* nodes)
      : interface_(interface), nodes_(nodes), neighbours_(neighboursAlong(interface))
  {
    for (int i = 0; i < interface.numNodes(); ++i) {
      largestForce_ = std::max(largestForce_, -nodes[i].nodalForce);
      largestGap_ = std::max(largestGap_, nodes[i].gap);
    }
  }

  const std::vector<int>& neighbours(int node) const { return neighbours_[std::size_t(node)]; }
  bool isClosed(int node) const { return nodes_[node].closed; }

  /// The first sure node from `node` on, walking away from its neighbour `behind`; none when the status changes before
  /// or the interface ends.
  std::optional<int> nearestSure(int node, int behind) const
  {
    const bool closed = isClosed(node);
    for (int steps = 0; steps < interface_.numNodes(); ++steps) { // an interface may be a ring
      if (isSure(node))
        return node;
      const auto& around = neighbours(node);
      const auto next = std::find_if(around.begin(), around.end(), [&](int other) { return other != behind; });
      if (next == around.end() || isClosed(*next) != closed)
        return std::nullopt;
      behind = std::exchange(node, *next);
    }
    return std::nullopt;
  }

  std::vector<double> point(int node) const { return {interface_.point(node), interface_.point(node) + 2}; }

private:
  bool isSure(int node) const
  {
    return isClosed(node) ? -nodes_[node].nodalForce > roundOff * largestForce_
                          : nodes_[node].gap > roundOff * largestGap_;
  }

  const InterfaceMesh& interface_;
  const ContactNode* nodes_;
  std::vector<std::vector<int>> neighbours_;
  double largestForce_ = 0.0, largestGap_ = 0.0;
};

} // namespace

std::vector<EndBracket> endBrackets(const InterfaceMesh& interface, const ContactNode* nodes)
{
  if (interface.dim != 2)
    return {};
  const Chain chain(interface, nodes);
  std::vector<EndBracket> brackets;
  for (int closed = 0; closed < interface.numNodes(); ++closed)
    for (const int open : chain.neighbours(closed)) {
      if (!chain.isClosed(closed) || chain.isClosed(open))
        continue;
      const auto pressed = chain.nearestSure(closed, open), apart = chain.nearestSure(open, closed);
      if (pressed && apart)
        brackets.push_back({chain.point(*pressed), chain.point(*apart)});
    }
  std::sort(brackets.begin(), brackets.end(), [](const EndBracket& a, const EndBracket& b) {
    return std::tie(a.closed, a.open) < std::tie(b.closed, b.open);
  });
  return brackets;
}

std::vector<int> endVertices(const InterfaceMesh& interface, const char* closed)
{
  std::vector<int> vertices;
  const int perFacet = interface.nodesPerFacet();
  for (int f = 0; f < interface.numFacets(); ++f) {
    const int* nodes = interface.nodesOf(f);
    for (int v = 0; v < 2; ++v)
      if (closed[nodes[v]] != closed[perFacet == 3 ? nodes[2] : nodes[1 - v]])
        vertices.push_back(nodes[v]);
  }
  return vertices;
}

} // namespace ndframe
