#include "node_owners.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/fem/node_map.hpp"
#include "ndframe/mesh/partition.hpp"

namespace ndframe
{
namespace
{

/// Vertices of some bodies, one number for those that touch each other.
class JoinedVertices
{
public:
  explicit JoinedVertices(const std::vector<int>& numPoints) : first_{0}
  {
    for (const int points : numPoints)
      first_.push_back(first_.back() + points);
    same_.resize(std::size_t(first_.back()));
    std::iota(same_.begin(), same_.end(), 0);
  }

  void join(int body, int node, int otherBody, int otherNode)
  {
    const int a = representative(first_[std::size_t(body)] + node);
    const int b = representative(first_[std::size_t(otherBody)] + otherNode);
    same_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  /// Numbers them; no more calls of join().
  int number()
  {
    int count = 0;
    for (std::size_t v = 0; v < same_.size(); ++v) // a representative is the smallest of its set
      same_[v] = same_[v] == int(v) ? count++ : same_[std::size_t(same_[v])];
    return count;
  }

  int operator()(int body, int node) const { return same_[std::size_t(first_[std::size_t(body)]) + std::size_t(node)]; }

private:
  int representative(int vertex)
  {
    while (same_[std::size_t(vertex)] != vertex)
      vertex = same_[std::size_t(vertex)] = same_[std::size_t(same_[std::size_t(vertex)])];
    return vertex;
  }

  std::vector<int> first_; ///< per body
  std::vector<int> same_;
};

/// Bodies that are shared out as one graph.
class Group
{
public:
  Group(const Model& model, std::vector<int> bodies) : model_(model), bodies_(std::move(bodies)), vertices_(points())
  {
    for (const InterfaceMesh& interface : model.interfaces)
      join(interface);
    count_ = vertices_.number();
    weights_.assign(std::size_t(count_), 0);
    eachNode([&](int, int, int vertex) { ++weights_[std::size_t(vertex)]; });
  }

  void shareOut(int ranks, std::vector<std::vector<int>>& owners) const
  {
    const int perCell = model_.bodies[std::size_t(bodies_.front())].mesh.dim + 1;
    std::vector<int> cells;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (const int point : body(b).mesh.cells)
        cells.push_back(vertices_(int(b), point));
    const std::vector<int> parts = partitionNodes(cells, perCell, count_, ranks, weights_);
    for (const int number : bodies_)
      owners[std::size_t(number)].resize(std::size_t(model_.bodies[std::size_t(number)].nodes.numNodes()));
    eachNode([&](int number, int node, int vertex) {
      owners[std::size_t(number)][std::size_t(node)] = parts[std::size_t(vertex)];
    });
  }

private:
  const BodyModel& body(std::size_t b) const { return model_.bodies[std::size_t(bodies_[b])]; }

  std::vector<int> points() const
  {
    std::vector<int> result;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      result.push_back(body(b).mesh.numPoints());
    return result;
  }

  void join(const InterfaceMesh& interface)
  {
    const auto placeOf = [this](const InterfaceSide& side) {
      return int(std::find(bodies_.begin(), bodies_.end(), side.body) - bodies_.begin());
    };
    const auto& [one, other] = interface.sides;
    const int a = placeOf(one), b = placeOf(other);
    if (a == int(bodies_.size()) || b == int(bodies_.size()))
      return;
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
      if (one.nodes[i] < body(std::size_t(a)).mesh.numPoints() &&
          other.nodes[i] < body(std::size_t(b)).mesh.numPoints())
        vertices_.join(a, one.nodes[i], b, other.nodes[i]);
  }

  /// action(body, node, the vertex that it goes with)
  template <class Action>
  void eachNode(const Action& action) const
  {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const NodeMap& nodes = body(b).nodes;
      for (int node = 0; node < nodes.numNodes(); ++node) {
        const auto [first, second] = nodes.ends(node);
        action(bodies_[b], node, std::min(vertices_(int(b), first), vertices_(int(b), second)));
      }
    }
  }

  const Model& model_;
  std::vector<int> bodies_;
  JoinedVertices vertices_;
  int count_ = 0;            ///< of vertices
  std::vector<int> weights_; ///< per vertex, nodes that go with it
};

} // namespace

NodeOwners::NodeOwners(const Model& model, int ranks)
{
  if (ranks == 1) {
    for (const BodyModel& body : model.bodies)
      ranks_.emplace_back(std::size_t(body.nodes.numNodes()), 0);
    return;
  }
  ranks_.resize(model.bodies.size());
  std::vector<int> all(model.bodies.size());
  std::iota(all.begin(), all.end(), 0);
  if (model.solvesWhole)
    Group(model, all).shareOut(ranks, ranks_);
  else
    for (const int body : all)
      Group(model, {body}).shareOut(ranks, ranks_);
}

std::vector<int> NodeOwners::ofVertices(const Model& model, int body) const
{
  const auto first = ranks_[std::size_t(body)].begin();
  return {first, first + model.bodies[std::size_t(body)].nodes.numVertices()};
}

std::vector<int> NodeOwners::ownedBy(int rank, int body) const
{
  const std::vector<int>& owners = ranks_[std::size_t(body)];
  std::vector<int> nodes;
  for (std::size_t node = 0; node < owners.size(); ++node)
    if (owners[node] == rank)
      nodes.push_back(int(node));
  return nodes;
}

} // namespace ndframe
