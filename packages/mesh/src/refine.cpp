#include "ndframe/mesh/refine.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

using Child = std::array<ChildVertex, 4>; ///< in two dimensions the last entry is not used

constexpr std::array<Child, 4> triangles{
    {{{{0, 0}, {0, 1}, {0, 2}}}, {{{0, 1}, {1, 1}, {1, 2}}}, {{{0, 2}, {1, 2}, {2, 2}}}, {{{1, 2}, {0, 2}, {0, 1}}}}};

/// Bey's order of the vertices, except that the first and the third of children 5 and 7 are exchanged, which makes them
/// positive and keeps what decides the next cut: that 02 and 13 are the opposite edges whose middles are joined.
constexpr std::array<Child, 8> tetrahedra{{{{{0, 0}, {0, 1}, {0, 2}, {0, 3}}},
                                           {{{0, 1}, {1, 1}, {1, 2}, {1, 3}}},
                                           {{{0, 2}, {1, 2}, {2, 2}, {2, 3}}},
                                           {{{0, 3}, {1, 3}, {2, 3}, {3, 3}}},
                                           {{{0, 1}, {0, 2}, {0, 3}, {1, 3}}},
                                           {{{1, 2}, {0, 2}, {0, 1}, {1, 3}}},
                                           {{{0, 2}, {0, 3}, {1, 3}, {2, 3}}},
                                           {{{1, 3}, {1, 2}, {0, 2}, {2, 3}}}}};

/// The edges of a mesh, numbered in the order of their vertices.
class Edges
{
public:
  explicit Edges(const Mesh& mesh) : vertices_(mesh.dim + 1), edgesPerCell_(mesh.dim * (mesh.dim + 1) / 2)
  {
    std::vector<int> pairs;
    pairs.reserve(std::size_t(mesh.numCells()) * 2 * std::size_t(edgesPerCell_));
    for (int c = 0; c < mesh.numCells(); ++c)
      for (int b = 1; b < vertices_; ++b)
        for (int a = 0; a < b; ++a)
          pairs.insert(pairs.end(), {mesh.cell(c)[a], mesh.cell(c)[b]});
    const VertexTuples tuples(pairs, 2, mesh.numPoints());
    number_.resize(std::size_t(tuples.size()));
    for (int place = 0, end = 0; place < tuples.size(); place = end) {
      end = tuples.groupEnd(place);
      const auto first = 2 * std::size_t(tuples.at(place));
      ends_.push_back({pairs[first], pairs[first + 1]});
      for (int p = place; p < end; ++p)
        number_[std::size_t(tuples.at(p))] = int(ends_.size()) - 1;
    }
  }

  const std::vector<std::array<int, 2>>& ends() const { return ends_; }
  /// a != b: local vertices of a cell.
  int number(int cell, int a, int b) const
  {
    const auto [low, high] = std::minmax(a, b);
    return number_[std::size_t(cell) * std::size_t(edgesPerCell_) + std::size_t(high) * std::size_t(high - 1) / 2 +
                   std::size_t(low)];
  }

private:
  int vertices_, edgesPerCell_;
  std::vector<std::array<int, 2>> ends_;
  std::vector<int> number_; ///< per cell and edge
};

/// The children's facets that lie on facet `local` of the parent: children by their number in the parent.
std::vector<Facet> childFacets(int dim, int local)
{
  std::vector<Facet> facets;
  for (int child = 0; child < numChildren(dim); ++child) {
    const ChildVertex* vertices = childVertices(dim, child);
    const auto isOff = [local](const ChildVertex& v) { return v[0] == local || v[1] == local; };
    if (std::count_if(vertices, vertices + dim + 1, isOff) == 1)
      facets.push_back({child, int(std::find_if(vertices, vertices + dim + 1, isOff) - vertices)});
  }
  return facets;
}

Side refineSide(const Side& side, int dim)
{
  std::vector<std::vector<Facet>> children;
  for (int local = 0; local <= dim; ++local)
    children.push_back(childFacets(dim, local));
  Side refined{side.name, {}};
  for (const Facet facet : side.facets)
    for (const Facet child : children[std::size_t(facet.local)])
      refined.facets.push_back({facet.cell * numChildren(dim) + child.cell, child.local});
  return refined;
}

} // namespace

int numChildren(int dim)
{
  return 1 << dim;
}

const ChildVertex* childVertices(int dim, int child)
{
  NDFRAME_ASSERT(child >= 0 && child < numChildren(dim), "a cell has 2^dim children");
  return dim == 2 ? triangles[std::size_t(child)].data() : tetrahedra[std::size_t(child)].data();
}

Mesh refineUniformly(const Mesh& mesh, std::vector<std::array<int, 2>>* middles)
{
  const Edges edges(mesh);
  Mesh refined{mesh.dim, mesh.points, {}, {}, mesh.notes, mesh.groups};
  refined.points.reserve(mesh.points.size() + edges.ends().size() * std::size_t(mesh.dim));
  for (const auto& [a, b] : edges.ends())
    for (int k = 0; k < mesh.dim; ++k)
      refined.points.push_back(0.5 * (mesh.point(a)[k] + mesh.point(b)[k]));
  refined.cells.reserve(mesh.cells.size() * std::size_t(numChildren(mesh.dim)));
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int child = 0; child < numChildren(mesh.dim); ++child)
      for (int v = 0; v <= mesh.dim; ++v) {
        const auto [a, b] = childVertices(mesh.dim, child)[v];
        refined.cells.push_back(a == b ? mesh.cell(c)[a] : mesh.numPoints() + edges.number(c, a, b));
      }
  for (const Side& side : mesh.sides)
    refined.sides.push_back(refineSide(side, mesh.dim));
  std::vector<int> parents(std::size_t(refined.numCells()));
  for (std::size_t c = 0; c < parents.size(); ++c)
    parents[c] = int(c) / numChildren(mesh.dim);
  refined.groups.inherit(parents);
  if (middles != nullptr)
    *middles = edges.ends();
  return refined;
}

} // namespace ndframe
