#include "ndframe/equilibrium/star_topology.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// One side of a spoke: the facet's other vertices tell which two sides belong together.
struct SpokeSide
{
  std::array<int, 2> others{-1, -1};
  int cell, facet;
};

std::vector<SpokeSide> spokeSides(const Star& star, int dim)
{
  std::vector<SpokeSide> sides;
  for (int c = 0; c < int(star.cells.size()); ++c) {
    const StarCell& cell = star.cells[std::size_t(c)];
    for (int facet = 0; facet <= dim; ++facet) {
      if (facet == cell.apex)
        continue;
      SpokeSide side{{-1, -1}, c, facet};
      std::size_t n = 0;
      for (int v = 0; v <= dim; ++v)
        if (v != facet && v != cell.apex)
          side.others[n++] = cell.sorted.vertices[std::size_t(v)];
      sides.push_back(side);
    }
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const SpokeSide& a, const SpokeSide& b) { return a.others < b.others; });
  return sides;
}

} // namespace

Star makeStar(const Mesh& mesh, const VertexCells& around, int vertex)
{
  Star star{vertex, {}, {}};
  for (const int* cell = around.begin(vertex); cell != around.end(vertex); ++cell) {
    const SortedCell sorted = sortedCell(mesh, *cell);
    const auto* apex = std::find(sorted.vertices.begin(), sorted.vertices.end(), vertex);
    star.cells.push_back({*cell, sorted, int(apex - sorted.vertices.begin())});
  }
  const std::vector<SpokeSide> sides = spokeSides(star, mesh.dim);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    Spoke spoke{{sides[s].cell, -1}, {sides[s].facet, -1}};
    if (s + 1 < sides.size() && sides[s].others == sides[s + 1].others) {
      ++s;
      spoke.cell[1] = sides[s].cell;
      spoke.facet[1] = sides[s].facet;
    }
    star.spokes.push_back(spoke);
  }
  return star;
}

SpanningTree spanningTree(const Star& star)
{
  SpanningTree tree{{0}, std::vector<int>(star.cells.size(), -1), std::vector<char>(star.spokes.size(), 0)};
  std::vector<char> reached(star.cells.size(), 0);
  reached[0] = 1;
  for (std::size_t next = 0; next < tree.order.size(); ++next)
    for (std::size_t s = 0; s < star.spokes.size(); ++s) {
      const Spoke& spoke = star.spokes[s];
      if (spoke.onBoundary() || (spoke.cell[0] != tree.order[next] && spoke.cell[1] != tree.order[next]))
        continue;
      const int other = spoke.cell[0] == tree.order[next] ? spoke.cell[1] : spoke.cell[0];
      if (reached[std::size_t(other)] != 0)
        continue;
      reached[std::size_t(other)] = 1;
      tree.order.push_back(other);
      tree.parent[std::size_t(other)] = int(s);
      tree.used[s] = 1;
    }
  return tree;
}

std::vector<std::vector<int>> colourVertices(const Mesh& mesh, const VertexCells& around)
{
  std::vector<int> colour(std::size_t(mesh.numPoints()), -1);
  std::vector<std::vector<int>> classes;
  std::vector<int> takenBy; // per colour the last vertex that saw it at a neighbour
  for (int vertex = 0; vertex < mesh.numPoints(); ++vertex) {
    for (const int* cell = around.begin(vertex); cell != around.end(vertex); ++cell)
      for (int v = 0; v <= mesh.dim; ++v)
        if (const int taken = colour[std::size_t(mesh.cell(*cell)[v])]; taken >= 0)
          takenBy[std::size_t(taken)] = vertex;
    const auto free = std::find_if(takenBy.begin(), takenBy.end(), [vertex](int taken) { return taken != vertex; });
    const std::size_t chosen = std::size_t(free - takenBy.begin());
    if (free == takenBy.end()) {
      takenBy.push_back(-1);
      classes.emplace_back();
    }
    colour[std::size_t(vertex)] = int(chosen);
    classes[chosen].push_back(vertex);
  }
  return classes;
}

} // namespace ndframe
