#include "ndframe/scene/joined_vertices.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/base/joined_numbers.hpp"
#include "ndframe/mesh/partition.hpp"

namespace ndframe
{

JoinedVertices joinedVertices(const std::vector<int>& numVertices, const std::vector<TouchingVertices>& touching)
{
  std::vector<int> first{0}; // vertex of each body, and the number of all
  for (const int vertices : numVertices)
    first.push_back(first.back() + vertices);
  JoinedNumbers numbers(first.back());
  for (const TouchingVertices& two : touching)
    for (const auto& [a, b] : two.pairs)
      numbers.join(first[two.first] + a, first[two.second] + b);
  JoinedVertices joined;
  const std::vector<int> all = std::move(numbers).numbered(joined.count);
  for (std::size_t b = 0; b < numVertices.size(); ++b)
    joined.numbers.emplace_back(all.begin() + first[b], all.begin() + first[b + 1]);
  return joined;
}

JoinedVertices joinedVertices(const Model& model, const std::vector<int>& bodies)
{
  std::vector<int> numVertices;
  for (const int body : bodies)
    numVertices.push_back(model.bodies[std::size_t(body)].mesh.numPoints());
  std::vector<TouchingVertices> touching;
  for (const InterfaceMesh& interface : model.interfaces) {
    const auto placeOf = [&](const InterfaceSide& side) {
      return std::size_t(std::find(bodies.begin(), bodies.end(), side.body) - bodies.begin());
    };
    const auto& [one, other] = interface.sides;
    const std::size_t a = placeOf(one), b = placeOf(other);
    if (a == bodies.size() || b == bodies.size())
      continue;
    touching.push_back({a, b, {}});
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
      if (one.nodes[i] < numVertices[a] && other.nodes[i] < numVertices[b]) // vertices of both
        touching.back().pairs.emplace_back(one.nodes[i], other.nodes[i]);
  }
  return joinedVertices(numVertices, touching);
}

std::vector<std::vector<int>> partitionJoined(const JoinedVertices& joined, const std::vector<const Mesh*>& meshes,
                                              const std::vector<const RefinedNumbers*>& numbers, int parts)
{
  constexpr double most = 1e9; // METIS adds them up in 32 bits
  std::vector<double> counts(std::size_t(joined.count), 0.0);
  std::vector<int> cells, weights;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    numbers[b]->countNodes(joined.numbers[b], counts);
    for (const int point : meshes[b]->cells)
      cells.push_back(joined(b, point));
  }
  const double scale = std::min(1.0, most / std::accumulate(counts.begin(), counts.end(), 0.0));
  for (const double count : counts)
    weights.push_back(std::max(1, int(scale * count)));
  const std::vector<int> part = partitionNodes(cells, meshes.front()->dim + 1, joined.count, parts, weights);
  std::vector<std::vector<int>> ofBodies;
  for (const std::vector<int>& ofBody : joined.numbers) {
    ofBodies.emplace_back();
    for (const int number : ofBody)
      ofBodies.back().push_back(part[std::size_t(number)]);
  }
  return ofBodies;
}

} // namespace ndframe
