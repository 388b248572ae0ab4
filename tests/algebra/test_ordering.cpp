// Which vertices take their place in an elimination order from others, and that nothing is lost by it.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>

#include "dominated_vertices.hpp"
#include "ordering.hpp"

using namespace ndframe;

namespace
{

using Neighbours = std::vector<std::set<int>>;

NodeGraph graphOf(const Neighbours& neighbours)
{
  NodeGraph graph;
  graph.starts.push_back(0);
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    graph.nodes.push_back(int(v));
    graph.neighbours.insert(graph.neighbours.end(), neighbours[v].begin(), neighbours[v].end());
    graph.starts.push_back(int(graph.neighbours.size()));
  }
  return graph;
}

/// A lattice of n points a side cut into simplices whose edges are `step` points long; their midpoints are nodes too
/// where that is 2.
class Lattice
{
public:
  Lattice(int dim, int cells, int step) : dim_(dim), side_(step * cells + 1), step_(step)
  {
    neighbours_.resize(std::size_t(std::pow(side_, dim)));
    std::vector<int> corner(std::size_t(dim), 0);
    addCells(corner, 0);
  }

  NodeGraph graph() const { return graphOf(neighbours_); }
  int numNodes() const { return int(neighbours_.size()); }

  bool isVertex(int node) const
  {
    for (int axis = 0; axis < dim_; ++axis, node /= side_)
      if (node % side_ % step_ != 0)
        return false;
    return true;
  }

private:
  void addCells(std::vector<int>& corner, std::size_t axis)
  {
    if (axis == corner.size())
      return addSimplices(corner);
    for (corner[axis] = 0; corner[axis] + 1 < side_; corner[axis] += step_)
      addCells(corner, axis + 1);
  }

  void addSimplices(const std::vector<int>& corner)
  {
    std::vector<std::size_t> axes(corner.size());
    std::iota(axes.begin(), axes.end(), 0);
    do {
      std::vector<std::vector<int>> vertices{corner};
      for (const std::size_t axis : axes) {
        vertices.push_back(vertices.back());
        vertices.back()[axis] += step_;
      }
      join(vertices);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void join(const std::vector<std::vector<int>>& vertices)
  {
    std::set<int> nodes;
    for (const auto& a : vertices)
      for (const auto& b : vertices) {
        int node = 0;
        for (std::size_t axis = a.size(); axis-- > 0;)
          node = node * side_ + (step_ == 2 ? (a[axis] + b[axis]) / 2 : a[axis]);
        nodes.insert(node);
      }
    for (const int v : nodes)
      for (const int w : nodes)
        if (v != w)
          neighbours_[std::size_t(v)].insert(w);
  }

  int dim_, side_, step_;
  Neighbours neighbours_;
};

Neighbours neighboursIn(const NodeGraph& graph)
{
  Neighbours neighbours;
  for (int v = 0; v < graph.size(); ++v)
    neighbours.emplace_back(graph.near(v).begin(), graph.near(v).end());
  return neighbours;
}

void eliminate(Neighbours& neighbours, int v)
{
  const std::set<int> left = std::exchange(neighbours[std::size_t(v)], {});
  for (const int w : left) {
    neighbours[std::size_t(w)].insert(left.begin(), left.end());
    neighbours[std::size_t(w)].erase(v);
    neighbours[std::size_t(w)].erase(w);
  }
}

/// Entries of the factor below its diagonal.
std::size_t factorEntries(const NodeGraph& graph, const std::vector<int>& order)
{
  Neighbours neighbours = neighboursIn(graph);
  std::size_t entries = 0;
  for (const int v : order) {
    entries += neighbours[std::size_t(v)].size();
    eliminate(neighbours, v);
  }
  return entries;
}

NodeGraph randomGraph(int size, double density, unsigned seed)
{
  std::mt19937 random(seed);
  std::bernoulli_distribution joined(density);
  Neighbours neighbours(static_cast<std::size_t>(size));
  for (int v = 0; v < size; ++v)
    for (int w = 0; w < v; ++w)
      if (joined(random)) {
        neighbours[std::size_t(v)].insert(w);
        neighbours[std::size_t(w)].insert(v);
      }
  return graphOf(neighbours);
}

/// Whether every vertex that is not in `rest` is eliminated while all that is near it is near the next one that is.
bool fillsNothingOfItsOwn(const NodeGraph& graph, const NodeGraph& rest, const std::vector<int>& order)
{
  const std::set<int> hosts(rest.nodes.begin(), rest.nodes.end());
  Neighbours neighbours = neighboursIn(graph);
  for (auto v = order.begin(); v != order.end(); ++v) {
    const auto host = std::find_if(v, order.end(), [&](int w) { return hosts.count(w) > 0; });
    if (host == order.end())
      return false;
    for (const int w : neighbours[std::size_t(*v)])
      if (host != v && w != *host && neighbours[std::size_t(*host)].count(w) == 0)
        return false;
    eliminate(neighbours, *v);
  }
  return true;
}

} // namespace

TEST(DominatedVertices, OfQuadraticElementsAreTheMidsideNodes)
{
  for (const int dim : {2, 3}) {
    const Lattice lattice(dim, 4, 2);
    const NodeGraph graph = lattice.graph();
    const NodeGraph rest = DominatedVertices(graph).rest(graph);
    for (const int v : rest.nodes)
      EXPECT_TRUE(lattice.isVertex(v)) << v;
    const int vertices = dim == 2 ? 25 : 125;
    EXPECT_GE(rest.size(), vertices - (dim == 2 ? 4 : 44)); // in corners, and in three dimensions on edges
    EXPECT_LE(rest.size(), vertices);
  }
}

TEST(DominatedVertices, OfLinearElementsAreInCorners)
{
  const NodeGraph graph = Lattice(2, 5, 1).graph();
  EXPECT_EQ(DominatedVertices(graph).rest(graph).size(), 36 - 4);
}

TEST(DominatedVertices, WeighUponTheirHosts)
{
  const NodeGraph star = graphOf({{1, 2, 3}, {0}, {0}, {0}});
  const NodeGraph rest = DominatedVertices(star).rest(star);
  EXPECT_THAT(rest.nodes, testing::ElementsAre(0));
  EXPECT_THAT(rest.weights, testing::ElementsAre(4));
}

TEST(DominatedVertices, AreEliminatedBeforeTheirHostsAndFillNothingOfTheirOwn)
{
  std::vector<NodeGraph> graphs{Lattice(2, 5, 2).graph(), Lattice(3, 2, 2).graph(), Lattice(2, 6, 1).graph()};
  for (unsigned seed = 0; seed < 20; ++seed)
    graphs.push_back(randomGraph(40, 0.02 * (seed + 1), seed));
  std::mt19937 random(1);
  for (const NodeGraph& graph : graphs) {
    const DominatedVertices dominated(graph);
    const NodeGraph rest = dominated.rest(graph);
    std::vector<int> restInOrder = rest.nodes;
    std::shuffle(restInOrder.begin(), restInOrder.end(), random);
    const std::vector<int> order = dominated.insertedInto(restInOrder);
    std::vector<int> all = order;
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, graph.nodes);
    EXPECT_TRUE(fillsNothingOfItsOwn(graph, rest, order));
  }
}

TEST(DominatedVertices, KeepTheOrderOfTheRest)
{
  const NodeGraph graph = Lattice(2, 3, 2).graph();
  const DominatedVertices dominated(graph);
  const std::vector<int> rest = dominated.rest(graph).nodes;
  std::vector<int> order = dominated.insertedInto(rest);
  const auto isDominated = [&](int v) { return !std::binary_search(rest.begin(), rest.end(), v); };
  order.erase(std::remove_if(order.begin(), order.end(), isDominated), order.end());
  EXPECT_EQ(order, rest);
}

TEST(ReducedDissection, IsAPermutationOfTheNodes)
{
  NodeGraph graph = Lattice(2, 7, 2).graph();
  for (int& node : graph.nodes)
    node = 3 * node + 5;
  std::vector<int> order = reducedDissection(graph);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, graph.nodes);
  EXPECT_TRUE(reducedDissection(graphOf({})).empty());
}

TEST(ReducedDissection, FillsHardlyMoreThanADissectionOfAllNodesOfTriangles)
{
  for (const int step : {1, 2})
    for (const int cells : {12, 30}) {
      const NodeGraph graph = Lattice(2, cells, step).graph();
      const double reduced = double(factorEntries(graph, reducedDissection(graph)));
      const double whole = double(factorEntries(graph, nestedDissection(graph)));
      EXPECT_LT(reduced, 1.1 * whole) << cells << " cells of order " << step;
    }
}
