#include "ndframe/fem/node_map.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

/// Numbers the edges of a mesh in the order of their first cell; edges are looked up in the list of their lower vertex.
class EdgeNumbering
{
public:
  explicit EdgeNumbering(int numPoints) : first_(std::size_t(numPoints), -1) {}

  int number(int a, int b)
  {
    const int low = std::min(a, b), high = std::max(a, b);
    for (int e = first_[std::size_t(low)]; e >= 0; e = next_[std::size_t(e)])
      if (high_[std::size_t(e)] == high)
        return e;
    next_.push_back(std::exchange(first_[std::size_t(low)], int(high_.size())));
    high_.push_back(high);
    return int(high_.size()) - 1;
  }
  int size() const { return int(high_.size()); }

private:
  std::vector<int> first_, next_, high_;
};

template <int dim>
NodeMap quadraticNodeMap(const Mesh& mesh)
{
  using Basis = Lagrange<dim, 2>;
  NodeMap map{dim, 2, Basis::nodes, Lagrange<dim - 1, 2>::nodes, {}, mesh.points, {}};
  map.cellNodes.reserve(std::size_t(mesh.numCells()) * Basis::nodes);
  EdgeNumbering edges(mesh.numPoints());
  for (int c = 0; c < mesh.numCells(); ++c) {
    const int* v = mesh.cell(c);
    map.cellNodes.insert(map.cellNodes.end(), v, v + Basis::vertices);
    for (const auto& edge : SimplexEdges<dim>::vertices) {
      const int known = edges.size();
      const int e = edges.number(v[edge[0]], v[edge[1]]);
      map.cellNodes.push_back(mesh.numPoints() + e);
      if (e == known)
        map.edges.push_back({v[edge[0]], v[edge[1]]});
    }
  }
  return map;
}

/// Local node numbers of all facets of one element type.
template <int dim, int order>
constexpr auto facetTable()
{
  using Face = Lagrange<dim - 1, order>;
  std::array<std::array<int, Face::nodes>, dim + 1> table{};
  for (int facet = 0; facet <= dim; ++facet) {
    int n = 0;
    for (int v = 0; v <= dim; ++v)
      if (v != facet)
        table[facet][n++] = v;
    for (const auto& edge : SimplexEdges<dim - 1>::vertices)
      for (int e = 0; order == 2 && e < Lagrange<dim, 2>::edges; ++e) {
        const auto cellEdge = SimplexEdges<dim>::vertices[e];
        const int a = table[facet][edge[0]], b = table[facet][edge[1]];
        if ((cellEdge[0] == a && cellEdge[1] == b) || (cellEdge[0] == b && cellEdge[1] == a))
          table[facet][n++] = dim + 1 + e;
      }
  }
  return table;
}

} // namespace

NodeMap makeNodeMap(const Mesh& mesh, int order)
{
  NDFRAME_ASSERT(order == 1 || order == 2, "the order of a node map is 1 or 2");
  if (order == 2)
    return mesh.dim == 2 ? quadraticNodeMap<2>(mesh) : quadraticNodeMap<3>(mesh);
  return NodeMap{mesh.dim, 1, mesh.dim + 1, mesh.dim, mesh.cells, mesh.points, {}};
}

std::vector<std::array<int, 2>> edgeEnds(const NodeMap& map)
{
  if (map.order == 1)
    return {};
  std::vector<std::array<int, 2>> ends;
  ends.reserve(std::size_t(map.numNodes()));
  for (int node = 0; node < map.numNodes(); ++node)
    ends.push_back(map.ends(node));
  return ends;
}

std::vector<double> nodePoints(const NodeMap& map)
{
  std::vector<double> points;
  points.reserve(std::size_t(map.numNodes()) * std::size_t(map.dim));
  for (int node = 0; node < map.numNodes(); ++node) {
    const auto x = map.point(node);
    points.insert(points.end(), x.begin(), x.begin() + map.dim);
  }
  return points;
}

const int* facetLocalNodes(int dim, int order, int localFacet)
{
  return withDimAndOrder(dim, order, [localFacet](auto d, auto p) {
    static constexpr auto table = facetTable<d(), p()>();
    return table[std::size_t(localFacet)].data();
  });
}

void facetNodes(const NodeMap& map, Facet facet, int* nodes)
{
  const int* local = facetLocalNodes(map.dim, map.order, facet.local);
  for (int n = 0; n < map.nodesPerFacet; ++n)
    nodes[n] = map.cell(facet.cell)[local[n]];
}

std::vector<int> sideNodes(const NodeMap& map, const Side& side)
{
  std::vector<int> nodes(side.facets.size() * std::size_t(map.nodesPerFacet));
  for (std::size_t f = 0; f < side.facets.size(); ++f)
    facetNodes(map, side.facets[f], nodes.data() + f * std::size_t(map.nodesPerFacet));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

} // namespace ndframe
