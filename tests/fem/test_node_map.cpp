#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

namespace
{

struct Case
{
  std::vector<int> cells;
  std::string pattern;
  int order;
};

std::vector<Case> allCases()
{
  std::vector<Case> cases;
  for (const int order : {1, 2}) {
    for (const char* pattern : {"Right", "Alternating", "Crossed"})
      cases.push_back({{3, 2}, pattern, order});
    for (const char* pattern : {"Right", "Alternating"})
      cases.push_back({{2, 3, 2}, pattern, order});
  }
  return cases;
}

std::string caseName(const testing::TestParamInfo<Case>& test)
{
  return test.param.pattern + std::to_string(test.param.cells.size()) + "DOrder" + std::to_string(test.param.order);
}

using Edges = std::vector<std::array<int, 2>>;

Edges cellEdges(int dim)
{
  if (dim == 2)
    return {SimplexEdges<2>::vertices.begin(), SimplexEdges<2>::vertices.end()};
  return {SimplexEdges<3>::vertices.begin(), SimplexEdges<3>::vertices.end()};
}

std::vector<double> coordinates(const NodeMap& map, int node)
{
  const auto x = map.point(node);
  return {x.begin(), x.begin() + map.dim};
}

std::vector<double> middle(const NodeMap& map, int a, int b)
{
  auto x = coordinates(map, a);
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = 0.5 * (x[k] + map.point(b)[k]);
  return x;
}

/// Distance of a point from the plane of a facet.
double distanceFromFacet(const Mesh& mesh, Facet facet, const double* x)
{
  double normal[3], distance = 0.0;
  int vertices[3];
  facetNormal(mesh, facet, normal);
  facetVertices(mesh, facet, vertices);
  for (int k = 0; k < mesh.dim; ++k)
    distance += normal[k] * (x[k] - mesh.point(vertices[0])[k]);
  return std::abs(distance);
}

} // namespace

struct NodeMapOf : testing::TestWithParam<Case>
{
  Mesh mesh = test::shaken(test::box(GetParam().cells, GetParam().pattern), 0.05, 2);
  NodeMap map = makeNodeMap(mesh, GetParam().order);
  std::vector<int> nodesOf(Facet facet) const
  {
    std::vector<int> nodes(static_cast<std::size_t>(map.nodesPerFacet));
    facetNodes(map, facet, nodes.data());
    return nodes;
  }
};

TEST_P(NodeMapOf, StartsWithThePointsAndCellsOfTheMesh)
{
  ASSERT_EQ(map.numCells(), mesh.numCells());
  EXPECT_TRUE(std::equal(mesh.points.begin(), mesh.points.end(), map.points.begin()));
  for (int c = 0; c < mesh.numCells(); ++c)
    EXPECT_TRUE(std::equal(mesh.cell(c), mesh.cell(c) + mesh.dim + 1, map.cell(c)));
}

TEST_P(NodeMapOf, HasEveryMidNodeInTheMiddleOfItsEdge)
{
  const Edges edges = map.order == 2 ? cellEdges(map.dim) : Edges();
  ASSERT_EQ(map.nodesPerCell, map.dim + 1 + int(edges.size()));
  for (int c = 0; c < map.numCells(); ++c)
    for (std::size_t e = 0; e < edges.size(); ++e)
      EXPECT_EQ(coordinates(map, map.cell(c)[map.dim + 1 + int(e)]),
                middle(map, map.cell(c)[edges[e][0]], map.cell(c)[edges[e][1]]));
}

TEST_P(NodeMapOf, NumbersSharedEdgesOnce)
{
  // Euler: V - E + F = 1 for triangles of a disk, V - E + F - C = 1 for tetrahedra of a ball.
  const int V = mesh.numPoints(), C = mesh.numCells();
  const int F = (4 * C + test::numBoundaryFacets(mesh)) / 2;
  const int E = mesh.dim == 2 ? V + C - 1 : V + F - C - 1;
  EXPECT_EQ(map.numNodes(), map.order == 1 ? V : V + E);
  std::set<std::vector<double>> places;
  for (int node = 0; node < map.numNodes(); ++node)
    EXPECT_TRUE(places.insert(coordinates(map, node)).second);
}

TEST_P(NodeMapOf, HasFacetNodesOnTheFacet)
{
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int local = 0; local <= mesh.dim; ++local) {
      const auto nodes = nodesOf({c, local});
      EXPECT_EQ(std::set<int>(nodes.begin(), nodes.end()).size(), nodes.size());
      for (const int node : nodes)
        EXPECT_LT(distanceFromFacet(mesh, {c, local}, map.point(node).data()), 1e-14);
      EXPECT_GT(distanceFromFacet(mesh, {c, local}, mesh.point(mesh.cell(c)[local])), 1e-3);
    }
}

TEST_P(NodeMapOf, HasFacetNodesInTheOrderOfTheFacetsOwnElement)
{
  const Edges edges = map.order == 1 ? Edges() : map.dim == 2 ? Edges{{0, 1}} : Edges{{0, 1}, {1, 2}, {2, 0}};
  ASSERT_EQ(map.nodesPerFacet, map.dim + int(edges.size()));
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int local = 0; local <= mesh.dim; ++local) {
      int vertices[3];
      facetVertices(mesh, {c, local}, vertices);
      const auto nodes = nodesOf({c, local});
      EXPECT_TRUE(std::equal(vertices, vertices + mesh.dim, nodes.begin()));
      for (std::size_t e = 0; e < edges.size(); ++e)
        EXPECT_EQ(coordinates(map, nodes[std::size_t(map.dim) + e]),
                  middle(map, vertices[edges[e][0]], vertices[edges[e][1]]));
    }
}

TEST_P(NodeMapOf, GivesNeighbouringCellsTheSameFacetNodes)
{
  std::map<std::set<int>, std::vector<std::set<int>>> nodesByVertices;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int local = 0; local <= mesh.dim; ++local) {
      const auto nodes = nodesOf({c, local});
      nodesByVertices[{nodes.begin(), nodes.begin() + mesh.dim}].push_back({nodes.begin(), nodes.end()});
    }
  int inside = 0;
  for (const auto& [vertices, sets] : nodesByVertices) {
    inside += sets.size() == 2 ? 1 : 0;
    EXPECT_EQ(sets.front(), sets.back());
  }
  EXPECT_EQ(2 * inside + test::numBoundaryFacets(mesh), (mesh.dim + 1) * mesh.numCells());
}

TEST_P(NodeMapOf, HasTheSameNodesForAnyNumberingOfTheMesh)
{
  const NodeMap other = makeNodeMap(test::renumbered(mesh, 9), map.order);
  std::set<std::vector<double>> places, otherPlaces;
  for (int node = 0; node < map.numNodes(); ++node)
    places.insert(coordinates(map, node));
  for (int node = 0; node < other.numNodes(); ++node)
    otherPlaces.insert(coordinates(other, node));
  EXPECT_EQ(places, otherPlaces);
}

TEST_P(NodeMapOf, HasAllNodesOfASideOnceAndAscending)
{
  const auto nodes = sideNodes(map, *mesh.findSide("top"));
  EXPECT_EQ(std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>()), nodes.end());
  std::vector<int> onTop;
  for (int node = 0; node < map.numNodes(); ++node)
    if (map.point(node)[map.dim - 1] == 1.0)
      onTop.push_back(node);
  EXPECT_EQ(nodes, onTop);
}

INSTANTIATE_TEST_SUITE_P(Boxes, NodeMapOf, testing::ValuesIn(allCases()), caseName);

TEST(NodeMap, OtherOrdersAreABug)
{
  const Mesh mesh = test::box({1, 1});
  EXPECT_THROW(makeNodeMap(mesh, 0), InternalError);
  EXPECT_THROW(makeNodeMap(mesh, 3), InternalError);
}

TEST(NodeMap, IsEmptyWithoutAMesh)
{
  EXPECT_EQ(NodeMap().numNodes(), 0);
  EXPECT_EQ(NodeMap().numCells(), 0);
}

} // namespace ndframe
