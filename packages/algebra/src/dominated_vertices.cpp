#include "dominated_vertices.hpp"

#include <algorithm>

namespace ndframe
{

DominatedVertices::DominatedVertices(const NodeGraph& graph) : isDominated_(graph.nodes.size(), 0)
{
  std::vector<int> nearOf(graph.nodes.size(), -1); // the last host that a vertex was found to be near of, or to be
  for (int host = 0; host < graph.size(); ++host) {
    nearOf[std::size_t(host)] = host;
    for (const int v : graph.near(host))
      nearOf[std::size_t(v)] = host;
    const auto isNear = [&](int v) { return nearOf[std::size_t(v)] == host; };
    for (const int v : graph.near(host)) {
      const auto near = graph.near(v);
      if (graph.degree(v) < graph.degree(host) && std::all_of(near.begin(), near.end(), isNear)) {
        isDominated_[std::size_t(v)] = 1;
        pairs_.push_back({v, host});
      }
    }
  }
  // Whoever dominates a host dominates its vertices too, so each of them keeps one.
  const auto hasDominatedHost = [&](const Pair& pair) { return isDominated_[std::size_t(pair.host)] != 0; };
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), hasDominatedHost), pairs_.end());
}

NodeGraph DominatedVertices::rest(const NodeGraph& graph) const
{
  NodeGraph rest;
  std::vector<int> number(graph.nodes.size(), -1);
  for (int v = 0; v < graph.size(); ++v)
    if (!isDominated_[std::size_t(v)]) {
      number[std::size_t(v)] = rest.size();
      rest.nodes.push_back(v);
    }
  rest.starts.push_back(0);
  for (const int v : rest.nodes) {
    for (const int neighbour : graph.near(v))
      if (number[std::size_t(neighbour)] >= 0)
        rest.neighbours.push_back(number[std::size_t(neighbour)]);
    rest.starts.push_back(int(rest.neighbours.size()));
  }
  rest.weights.assign(rest.nodes.size(), 1);
  for (const Pair& pair : pairs_)
    ++rest.weights[std::size_t(number[std::size_t(pair.host)])];
  return rest;
}

std::vector<int> DominatedVertices::insertedInto(const std::vector<int>& restInOrder) const
{
  const std::size_t numRest = restInOrder.size();
  std::vector<std::size_t> place(isDominated_.size(), numRest); // the position in `restInOrder` to be before or at
  for (std::size_t k = 0; k < numRest; ++k)
    place[std::size_t(restInOrder[k])] = k;
  for (const Pair& pair : pairs_)
    place[std::size_t(pair.vertex)] = std::min(place[std::size_t(pair.vertex)], place[std::size_t(pair.host)]);
  std::vector<std::size_t> next(numRest + 1, 0);
  for (const std::size_t k : place)
    ++next[k + 1];
  for (std::size_t k = 0; k < numRest; ++k)
    next[k + 1] += next[k];
  std::vector<int> order(place.size());
  for (std::size_t v = 0; v < place.size(); ++v)
    if (isDominated_[v])
      order[next[place[v]]++] = int(v);
  for (std::size_t k = 0; k < numRest; ++k)
    order[next[k]] = restInOrder[k];
  return order;
}

} // namespace ndframe
