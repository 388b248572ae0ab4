#include "ndframe/scene/joined_vertices.hpp"

#include <algorithm>

#include "ndframe/base/joined_numbers.hpp"

namespace ndframe
{

JoinedVertices joinedVertices(const Model& model, const std::vector<int>& bodies)
{
  std::vector<int> first{0}; // vertex of each body, and the number of all
  for (const int body : bodies)
    first.push_back(first.back() + model.bodies[std::size_t(body)].mesh.numPoints());
  JoinedNumbers numbers(first.back());
  for (const InterfaceMesh& interface : model.interfaces) {
    const auto placeOf = [&](const InterfaceSide& side) {
      return std::size_t(std::find(bodies.begin(), bodies.end(), side.body) - bodies.begin());
    };
    const auto& [one, other] = interface.sides;
    const std::size_t a = placeOf(one), b = placeOf(other);
    if (a == bodies.size() || b == bodies.size())
      continue;
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
      if (one.nodes[i] < first[a + 1] - first[a] && other.nodes[i] < first[b + 1] - first[b]) // vertices of both
        numbers.join(first[a] + one.nodes[i], first[b] + other.nodes[i]);
  }
  JoinedVertices joined;
  const std::vector<int> all = std::move(numbers).numbered(joined.count);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    joined.numbers.emplace_back(all.begin() + first[b], all.begin() + first[b + 1]);
  return joined;
}

} // namespace ndframe
