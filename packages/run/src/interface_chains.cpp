#include "ndframe/run/interface_chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace ndframe
{
namespace
{

std::tuple<double, double> position(const InterfaceMesh& interface, int node)
{
  return {interface.point(node)[0], interface.point(node)[1]};
}

/// From `first` along the nodes that no piece has yet.
std::vector<int> walk(int first, const std::vector<std::vector<int>>& neighbours, std::vector<char>& taken)
{
  std::vector<int> chain;
  for (int node = first; node >= 0;) {
    chain.push_back(node);
    taken[std::size_t(node)] = 1;
    const auto& around = neighbours[std::size_t(node)];
    const auto next = std::find_if(around.begin(), around.end(), [&](int other) { return !taken[std::size_t(other)]; });
    node = next == around.end() ? -1 : *next;
  }
  return chain;
}

/// Turns a piece with ends towards larger coordinates.
void orient(std::vector<int>& chain, const InterfaceMesh& interface)
{
  const double *a = interface.point(chain.front()), *b = interface.point(chain.back());
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  if ((std::abs(dx) >= std::abs(dy) ? dx : dy) < 0.0)
    std::reverse(chain.begin(), chain.end());
}

} // namespace

std::vector<std::vector<int>> neighboursAlong(const InterfaceMesh& interface)
{
  std::vector<std::vector<int>> neighbours(std::size_t(interface.numNodes()));
  const auto link = [&](int a, int b) {
    neighbours[std::size_t(a)].push_back(b);
    neighbours[std::size_t(b)].push_back(a);
  };
  for (int f = 0; f < interface.numFacets(); ++f) {
    const int* nodes = interface.nodesOf(f);
    if (interface.order == 1)
      link(nodes[0], nodes[1]);
    else { // the node between the ends comes last
      link(nodes[0], nodes[2]);
      link(nodes[2], nodes[1]);
    }
  }
  std::map<int, int> first; // the two nodes of a corner
  for (int i = 0; i < interface.numNodes(); ++i)
    if (const auto [known, isNew] = first.emplace(interface.dirichlet().nodes[std::size_t(i)], i); !isNew)
      link(known->second, i);
  return neighbours;
}

std::vector<std::vector<int>> chainsOf(const InterfaceMesh& interface)
{
  const auto neighbours = neighboursAlong(interface);
  std::vector<char> taken(neighbours.size(), 0);
  std::vector<int> order(neighbours.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = int(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return position(interface, a) < position(interface, b); });
  std::vector<std::vector<int>> chains;
  for (const bool fromEnds : {true, false}) // what is left then are rings
    for (const int node : order)
      if (!taken[std::size_t(node)] && (!fromEnds || neighbours[std::size_t(node)].size() == 1)) {
        chains.push_back(walk(node, neighbours, taken));
        if (fromEnds)
          orient(chains.back(), interface);
      }
  std::sort(chains.begin(), chains.end(), [&](const auto& a, const auto& b) {
    return position(interface, a.front()) < position(interface, b.front());
  });
  return chains;
}

std::vector<ContactNode> sortedAlong(const std::vector<InterfaceMesh>& interfaces,
                                     const std::vector<ContactNode>& nodes)
{
  if (interfaces.empty() || interfaces.front().dim != 2)
    return nodes;
  std::vector<ContactNode> sorted;
  std::size_t firstNode = 0;
  for (const auto& interface : interfaces) {
    for (const auto& chain : chainsOf(interface)) {
      double length = 0.0;
      const double* before = interface.point(chain.front());
      for (const int node : chain) {
        const double* here = interface.point(node);
        length += std::hypot(here[0] - before[0], here[1] - before[1]);
        before = here;
        sorted.push_back(nodes[firstNode + std::size_t(node)]);
        sorted.back().arcLength = length;
      }
    }
    firstNode += std::size_t(interface.numNodes());
  }
  return sorted;
}

} // namespace ndframe
