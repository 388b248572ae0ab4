#include "ndframe/mesh/bisection.hpp"

#include <algorithm>
#include <cmath>

#include "bisection_peaks.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{

namespace
{

/// Twins are met in opposite directions: the first end of one is the second end of the other.
bool areOpposite(const Mesh& a, Facet facetA, const Mesh& b, Facet facetB)
{
  const auto end = [](const Mesh& mesh, Facet facet, int step) {
    return mesh.point(mesh.cell(facet.cell)[(facet.local + step) % 3]);
  };
  const auto distance = [](const double* x, const double* y) { return std::hypot(x[0] - y[0], x[1] - y[1]); };
  const double *firstA = end(a, facetA, 1), *secondA = end(a, facetA, 2);
  const double *firstB = end(b, facetB, 1), *secondB = end(b, facetB, 2);
  return distance(firstA, secondB) + distance(secondA, firstB) < distance(firstA, firstB) + distance(secondA, secondB);
}

} // namespace

Bisection::Bisection(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins)
    : meshes_(std::move(meshes)), parents_(meshes_.size())
{
  for (const Mesh& mesh : meshes_)
    addTriangles(mesh);
  for (const FacetTwin& twin : twins)
    identify(twin);
  for (int t = 0; t < int(triangles_.size()); ++t) {
    for (const DirectedEdge edge : triangles_[std::size_t(t)].edges)
      NDFRAME_ASSERT(edges_[std::size_t(edge / 2)].slots[std::size_t(edge % 2)] < 0, "twins have no other neighbour");
    linkEdges(t);
  }
  choosePeaks();
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    sides_.emplace_back();
    for (const Side& side : meshes_[m].sides) {
      sides_[m].emplace_back();
      for (const Facet facet : side.facets)
        sides_[m].back().push_back(
            triangles_[std::size_t(begin_[m]) + std::size_t(facet.cell)].edges[std::size_t(facet.local)]);
    }
    writeMesh(int(m));
  }
}

void Bisection::addTriangles(const Mesh& mesh)
{
  NDFRAME_ASSERT(mesh.dim == 2, "only triangles are bisected");
  for (int c = 0; c < mesh.numCells(); ++c) {
    const int* v = mesh.cell(c);
    triangles_.push_back({{v[0], v[1], v[2]}, {}, 0, c, 0});
  }
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    NDFRAME_ASSERT(end - place <= 2, "an edge of a sound mesh has one or two triangles");
    for (int p = place; p < end; ++p)
      triangles_[std::size_t(begin_.back()) + std::size_t(facets.at(p) / 3)].edges[std::size_t(facets.at(p) % 3)] =
          2 * int(edges_.size()) + (p - place);
    edges_.emplace_back();
  }
  begin_.push_back(int(triangles_.size()));
}

void Bisection::identify(const FacetTwin& twin)
{
  const auto edgeOf = [this](int mesh, Facet facet) -> DirectedEdge& {
    return triangles_[std::size_t(begin_[std::size_t(mesh)]) + std::size_t(facet.cell)].edges[std::size_t(facet.local)];
  };
  NDFRAME_ASSERT(areOpposite(meshes_[std::size_t(twin.first)], twin.firstFacet, meshes_[std::size_t(twin.second)],
                             twin.secondFacet),
                 "twins lie on each other, with their bodies on different sides");
  edgeOf(twin.second, twin.secondFacet) = edgeOf(twin.first, twin.firstFacet) ^ 1;
}

void Bisection::choosePeaks()
{
  std::vector<std::array<int, 3>> edges;
  edges.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_)
    edges.push_back({triangle.edges[0] / 2, triangle.edges[1] / 2, triangle.edges[2] / 2});
  const std::vector<int> peaks = firstPeaks(meshes_, edges, int(edges_.size()));
  for (std::size_t t = 0; t < peaks.size(); ++t)
    triangles_[t].peak = peaks[t];
}

void Bisection::linkEdges(int triangle)
{
  for (int k = 0; k < 3; ++k) {
    const DirectedEdge edge = triangles_[std::size_t(triangle)].edges[std::size_t(k)];
    edges_[std::size_t(edge / 2)].slots[std::size_t(edge % 2)] = 3 * triangle + k;
  }
}

void Bisection::refine(const std::vector<std::vector<int>>& halvings)
{
  NDFRAME_ASSERT(halvings.size() == meshes_.size(), "one list of halvings a mesh");
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    NDFRAME_ASSERT(int(halvings[m].size()) == meshes_[m].numCells(), "one number of halvings a cell");
    for (int c = 0; c < meshes_[m].numCells(); ++c) {
      Triangle& triangle = triangles_[std::size_t(begin_[m]) + std::size_t(c)];
      triangle.parent = c;
      triangle.halvings = halvings[m][std::size_t(c)];
    }
  }
  while (markWanted()) {
    close();
    halveMarked();
  }
  swapEdges();
  for (std::size_t m = 0; m < meshes_.size(); ++m)
    writeMesh(int(m));
}

/// One halving a round: what comes next is for the halves to choose.
bool Bisection::markWanted()
{
  for (const Triangle& triangle : triangles_)
    if (triangle.halvings > 0)
      mark(triangle.edges[std::size_t(triangle.peak)]);
  return !marked_.empty();
}

void Bisection::mark(DirectedEdge edge)
{
  if (edges_[std::size_t(edge / 2)].child >= 0)
    return;
  edges_[std::size_t(edge / 2)].child = int(edges_.size());
  edges_.resize(edges_.size() + 2);
  marked_.push_back(edge / 2);
}

void Bisection::close()
{
  while (!marked_.empty()) {
    const std::array<int, 2> slots = edges_[std::size_t(marked_.back())].slots;
    marked_.pop_back();
    for (const int slot : slots)
      if (slot >= 0) {
        const Triangle& triangle = triangles_[std::size_t(slot / 3)];
        mark(triangle.edges[std::size_t(triangle.peak)]);
      }
  }
}

void Bisection::halveMarked()
{
  const std::vector<Triangle> before = std::move(triangles_);
  const std::vector<int> begin = begin_;
  triangles_ = {};
  triangles_.reserve(2 * before.size());
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    for (int t = begin[m]; t < begin[m + 1]; ++t) {
      const int first = int(triangles_.size());
      addDescendants(before[std::size_t(t)], int(m));
      if (int(triangles_.size()) > first + 1)
        mendPeaks(first, int(m));
    }
    begin_[m + 1] = int(triangles_.size());
  }
}

/// Of the triangles that have just come into being.
void Bisection::mendPeaks(int first, int mesh)
{
  for (int t = first; t < int(triangles_.size()); ++t) {
    Triangle& triangle = triangles_[std::size_t(t)];
    triangle.peak = mendedPeak(cornersOf(triangle, mesh), triangle.peak);
    for (const DirectedEdge edge : triangle.edges)
      unchecked_.push_back(edge / 2);
  }
}

/// The halves of the refinement edge and what lies between are new and not marked, so this goes two generations deep.
void Bisection::addDescendants(const Triangle& triangle, int mesh)
{
  const auto peak = std::size_t(triangle.peak), a = (peak + 1) % 3, b = (peak + 2) % 3;
  const DirectedEdge base = triangle.edges[peak]; // from a to b
  if (edges_[std::size_t(base / 2)].child < 0) {
    triangles_.push_back(triangle);
    linkEdges(int(triangles_.size()) - 1);
    return;
  }
  const int middle = middleOf(triangle, mesh);
  const DirectedEdge inside = 2 * int(edges_.size()); // from the middle to the peak
  edges_.emplace_back();
  Triangle first = triangle, second = triangle;
  first.vertices[b] = second.vertices[a] = middle;
  first.edges[peak] = childOf(base, 0);
  first.edges[a] = inside;
  first.peak = int(b);
  second.edges[peak] = childOf(base, 1);
  second.edges[b] = inside + 1;
  second.peak = int(a);
  first.halvings = second.halvings = std::max(0, triangle.halvings - 1);
  addDescendants(first, mesh);
  addDescendants(second, mesh);
}

std::array<const double*, 3> Bisection::cornersOf(const Triangle& triangle, int mesh) const
{
  const Mesh& owner = meshes_[std::size_t(mesh)];
  return {owner.point(triangle.vertices[0]), owner.point(triangle.vertices[1]), owner.point(triangle.vertices[2])};
}

/// The middle of the refinement edge; a new point for the first triangle of this mesh that asks.
int Bisection::middleOf(const Triangle& triangle, int mesh)
{
  const auto peak = std::size_t(triangle.peak);
  Edge& edge = edges_[std::size_t(triangle.edges[peak] / 2)];
  if (edge.middleMesh != mesh) {
    Mesh& owner = meshes_[std::size_t(mesh)];
    edge.middleMesh = mesh;
    edge.middle = owner.numPoints();
    const int a = triangle.vertices[(peak + 1) % 3], b = triangle.vertices[(peak + 2) % 3];
    for (int k = 0; k < 2; ++k)
      owner.points.push_back(0.5 * (owner.point(a)[k] + owner.point(b)[k]));
  }
  return edge.middle;
}

/// The first (0) or second (1) half that is met on the way along a marked edge.
Bisection::DirectedEdge Bisection::childOf(DirectedEdge edge, int place) const
{
  const int direction = edge % 2;
  return 2 * (edges_[std::size_t(edge / 2)].child + (place ^ direction)) + direction;
}

void Bisection::writeMesh(int number)
{
  const auto m = std::size_t(number);
  Mesh& mesh = meshes_[m];
  mesh.cells.clear();
  parents_[m].clear();
  for (int t = begin_[m]; t < begin_[m + 1]; ++t) {
    const Triangle& triangle = triangles_[std::size_t(t)];
    mesh.cells.insert(mesh.cells.end(), triangle.vertices.begin(), triangle.vertices.end());
    parents_[m].push_back(triangle.parent);
  }
  mesh.groups.inherit(parents_[m]);
  for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
    std::vector<DirectedEdge> leaves;
    for (const DirectedEdge edge : sides_[m][s])
      addLeaves(edge, leaves);
    sides_[m][s] = std::move(leaves);
    mesh.sides[s].facets.clear();
    for (const DirectedEdge edge : sides_[m][s]) {
      const int slot = edges_[std::size_t(edge / 2)].slots[std::size_t(edge % 2)];
      mesh.sides[s].facets.push_back({slot / 3 - begin_[m], slot % 3});
    }
  }
}

void Bisection::addLeaves(DirectedEdge edge, std::vector<DirectedEdge>& leaves) const
{
  if (edges_[std::size_t(edge / 2)].child < 0) {
    leaves.push_back(edge);
    return;
  }
  addLeaves(childOf(edge, 0), leaves);
  addLeaves(childOf(edge, 1), leaves);
}

} // namespace ndframe
