#include "ndframe/coupling/odd_cycle.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// Breadth-first trees over the nodes.
class Forest
{
public:
  Forest(int numNodes, const std::vector<std::pair<int, int>>& edges)
      : neighbours_(std::size_t(numNodes)), parent_(std::size_t(numNodes), -1), depth_(std::size_t(numNodes), -1)
  {
    for (const auto& [a, b] : edges) {
      neighbours_[std::size_t(a)].push_back(b);
      neighbours_[std::size_t(b)].push_back(a);
    }
    for (int root = 0; root < numNodes; ++root)
      if (depth(root) < 0)
        grow(root);
  }

  bool closesOddly(int a, int b) const { return (depth(a) - depth(b)) % 2 == 0; }

  /// The way from a up to where both ways meet, and down to b.
  std::vector<int> way(int a, int b) const
  {
    std::vector<int> up{a}, down{b};
    while (up.back() != down.back()) {
      std::vector<int>& lower = depth(up.back()) >= depth(down.back()) ? up : down;
      lower.push_back(parent_[std::size_t(lower.back())]);
    }
    up.insert(up.end(), down.rbegin() + 1, down.rend());
    return up;
  }

private:
  int depth(int node) const { return depth_[std::size_t(node)]; }

  void grow(int root)
  {
    std::vector<int> queue{root};
    depth_[std::size_t(root)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const int next : neighbours_[std::size_t(queue[i])])
        if (depth(next) < 0) {
          depth_[std::size_t(next)] = depth(queue[i]) + 1;
          parent_[std::size_t(next)] = queue[i];
          queue.push_back(next);
        }
  }

  std::vector<std::vector<int>> neighbours_;
  std::vector<int> parent_, depth_;
};

} // namespace

std::vector<int> oddCycle(int numNodes, const std::vector<std::pair<int, int>>& edges)
{
  const Forest forest(numNodes, edges);
  std::vector<int> shortest;
  for (const auto& [a, b] : edges)
    if (forest.closesOddly(a, b))
      if (std::vector<int> cycle = forest.way(a, b); shortest.empty() || cycle.size() < shortest.size())
        shortest = std::move(cycle);
  return shortest;
}

} // namespace ndframe
