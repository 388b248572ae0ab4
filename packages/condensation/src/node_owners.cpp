#include "node_owners.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/fem/node_map.hpp"
#include "ndframe/mesh/partition.hpp"
#include "ndframe/scene/joined_vertices.hpp"

namespace ndframe
{
namespace
{

/// Bodies that are shared out as one graph.
class Group
{
public:
  Group(const Model& model, std::vector<int> bodies)
      : model_(model), bodies_(std::move(bodies)), vertices_(joinedVertices(model, bodies_)),
        weights_(std::size_t(vertices_.count), 0)
  {
    eachNode([&](int, int, int vertex) { ++weights_[std::size_t(vertex)]; });
  }

  void shareOut(int ranks, std::vector<std::vector<int>>& owners) const
  {
    const int perCell = model_.bodies[std::size_t(bodies_.front())].mesh.dim + 1;
    std::vector<int> cells;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (const int point : body(b).mesh.cells)
        cells.push_back(vertices_(b, point));
    const std::vector<int> parts = partitionNodes(cells, perCell, vertices_.count, ranks, weights_);
    for (const int number : bodies_)
      owners[std::size_t(number)].resize(std::size_t(model_.bodies[std::size_t(number)].nodes.numNodes()));
    eachNode([&](int number, int node, int vertex) {
      owners[std::size_t(number)][std::size_t(node)] = parts[std::size_t(vertex)];
    });
  }

private:
  const BodyModel& body(std::size_t b) const { return model_.bodies[std::size_t(bodies_[b])]; }

  /// action(body, node, the vertex that it goes with)
  template <class Action>
  void eachNode(const Action& action) const
  {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const NodeMap& nodes = body(b).nodes;
      for (int node = 0; node < nodes.numNodes(); ++node) {
        const auto [first, second] = nodes.ends(node);
        action(bodies_[b], node, std::min(vertices_(b, first), vertices_(b, second)));
      }
    }
  }

  const Model& model_;
  std::vector<int> bodies_;
  JoinedVertices vertices_;
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
