#include "ndframe/scene/joined_vertices.hpp"

#include <algorithm>
#include <numeric>

namespace ndframe
{
namespace
{

/// Sets of numbers; each has its smallest as representative.
class JoinedNumbers
{
public:
  explicit JoinedNumbers(int size) : same_(std::size_t(size)) { std::iota(same_.begin(), same_.end(), 0); }

  void join(int first, int second)
  {
    const int a = representative(first), b = representative(second);
    same_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  /// Per number that of its set, from 0 on.
  std::vector<int> numbered(int& count) &&
  {
    count = 0;
    for (std::size_t v = 0; v < same_.size(); ++v) // a representative is the smallest of its set
      same_[v] = same_[v] == int(v) ? count++ : same_[std::size_t(same_[v])];
    return std::move(same_);
  }

private:
  int representative(int number)
  {
    while (same_[std::size_t(number)] != number)
      number = same_[std::size_t(number)] = same_[std::size_t(same_[std::size_t(number)])];
    return number;
  }

  std::vector<int> same_;
};

} // namespace

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
