#include "ndframe/mesh/tetrahedron_bisection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

using Point = std::array<double, 3>;

constexpr int none = -1;

std::uint64_t edgeKey(int a, int b)
{
  return (std::uint64_t(std::min(a, b)) << 32) | std::uint64_t(std::max(a, b));
}

Point middle(const Point& a, const Point& b)
{
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

double squaredDistance(const double* a, const double* b)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// What edges are ordered by: lengths in steps of 1e-6, so that equal ones that differ by round-off are equal, then
/// where the edge is.
using Rank = std::tuple<std::int64_t, Point>;

Rank rankOf(const Point& a, const Point& b)
{
  constexpr double steps = 1 << 19;      // of a factor 2 in the squared length
  constexpr double awayFromHalves = 0.3; // where lengths in simple ratios would be rounded either way
  return {std::llround(std::log2(squaredDistance(a.data(), b.data())) * steps + awayFromHalves), middle(a, b)};
}

int rootOf(const std::vector<int>& parents, int vertex)
{
  const int parent = parents[std::size_t(vertex)];
  return parent == vertex ? vertex : rootOf(parents, parent);
}

} // namespace

TetrahedronBisection::TetrahedronBisection(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins)
    : meshes_(std::move(meshes)), parents_(meshes_.size()), points_(meshes_.size())
{
  for (const Mesh& mesh : meshes_) {
    addCells(mesh);
    numberFacets(mesh);
  }
  identify(twins);
  for (std::size_t m = 0; m < meshes_.size(); ++m)
    writeMesh(m);
}

void TetrahedronBisection::addCells(const Mesh& mesh)
{
  NDFRAME_ASSERT(mesh.dim == 3, "only tetrahedra are bisected");
  cells_.emplace_back();
  for (int c = 0; c < mesh.numCells(); ++c) {
    const int* v = mesh.cell(c);
    cells_.back().push_back({{v[0], v[1], v[2], v[3]}, {none, none, none, none}, c, 0});
  }
  const int before = int(places_.size());
  shared_.emplace_back(std::size_t(mesh.numPoints()));
  std::iota(shared_.back().begin(), shared_.back().end(), before);
  for (int p = 0; p < mesh.numPoints(); ++p)
    places_.push_back({mesh.point(p)[0], mesh.point(p)[1], mesh.point(p)[2]});
}

/// A facet may be in several sides.
void TetrahedronBisection::numberFacets(const Mesh& mesh)
{
  sides_.emplace_back();
  numFacets_.push_back(0);
  for (const Side& side : mesh.sides) {
    sides_.back().emplace_back();
    for (const Facet facet : side.facets) {
      int& number = cells_.back()[std::size_t(facet.cell)].facets[std::size_t(facet.local)];
      if (number == none)
        number = numFacets_.back()++;
      sides_.back().back().push_back(number);
    }
  }
}

void TetrahedronBisection::identify(const std::vector<FacetTwin>& twins)
{
  std::vector<int> root(places_.size());
  std::iota(root.begin(), root.end(), 0);
  for (const FacetTwin& twin : twins) {
    const auto first = std::size_t(twin.first), second = std::size_t(twin.second);
    for (const auto& [a, b] : sameVertices(meshes_[first], twin.firstFacet, meshes_[second], twin.secondFacet))
      root[std::size_t(rootOf(root, shared_[first][std::size_t(a)]))] = rootOf(root, shared_[second][std::size_t(b)]);
  }
  for (auto& ofMesh : shared_)
    for (int& vertex : ofMesh) {
      const int own = vertex;
      vertex = rootOf(root, own);
      Point& place = places_[std::size_t(vertex)];
      place = std::min(place, places_[std::size_t(own)]); // twins differ by round-off: not by who comes first
    }
}

void TetrahedronBisection::refine(const std::vector<std::vector<int>>& halvings)
{
  NDFRAME_ASSERT(halvings.size() == meshes_.size(), "one list of halvings a mesh");
  std::vector<int> numOld;
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    NDFRAME_ASSERT(int(halvings[m].size()) == meshes_[m].numCells(), "one number of halvings a cell");
    numOld.push_back(meshes_[m].numPoints());
    for (std::size_t c = 0; c < cells_[m].size(); ++c) {
      cells_[m][c].parent = int(c);
      cells_[m][c].halvings = halvings[m][c];
    }
  }
  isEnd_.assign(places_.size(), 0);
  while (halveOnce())
    continue;
  halved_.clear();
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    points_[m].clear();
    numberNewPoints(m, numOld[m]);
    writeMesh(m);
  }
}

/// False when there was nothing to be halved.
bool TetrahedronBisection::halveOnce()
{
  const std::size_t before = halved_.size();
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    const std::vector<Tetrahedron> cells = std::exchange(cells_[m], {});
    cells_[m].reserve(2 * cells.size());
    for (const Tetrahedron& cell : cells)
      addDescendants(cell, m);
  }
  return halved_.size() > before;
}

void TetrahedronBisection::addDescendants(const Tetrahedron& cell, std::size_t mesh)
{
  if (cell.halvings == 0 && !hasHalvedEdge(cell, mesh)) {
    cells_[mesh].push_back(cell);
    return;
  }
  const auto [a, b] = longestEdge(cell, mesh);
  const int between = middleOf(cell.vertices[a], cell.vertices[b], mesh);
  Tetrahedron first = cell, second = cell; // what each keeps of the edge: a, b
  first.vertices[b] = second.vertices[a] = between;
  first.facets[a] = second.facets[b] = none; // the cut
  first.halvings = second.halvings = std::max(0, cell.halvings - 1);
  addDescendants(first, mesh);
  addDescendants(second, mesh);
}

bool TetrahedronBisection::hasHalvedEdge(const Tetrahedron& cell, std::size_t mesh) const
{
  for (std::size_t b = 1; b < 4; ++b) {
    const int second = shared_[mesh][std::size_t(cell.vertices[b])];
    if (!isEnd_[std::size_t(second)])
      continue;
    for (std::size_t a = 0; a < b; ++a) {
      const int first = shared_[mesh][std::size_t(cell.vertices[a])];
      if (isEnd_[std::size_t(first)] && halved_.count(edgeKey(first, second)) > 0)
        return true;
    }
  }
  return false;
}

/// Two local vertices, ascending.
std::array<std::size_t, 2> TetrahedronBisection::longestEdge(const Tetrahedron& cell, std::size_t mesh) const
{
  const auto placeOf = [&](std::size_t k) -> const Point& {
    return places_[std::size_t(shared_[mesh][std::size_t(cell.vertices[k])])];
  };
  std::array<std::size_t, 2> longest{0, 1};
  Rank largest = rankOf(placeOf(0), placeOf(1));
  for (std::size_t b = 2; b < 4; ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (Rank rank = rankOf(placeOf(a), placeOf(b)); rank > largest) {
        largest = rank;
        longest = {a, b};
      }
  return longest;
}

/// The point of a mesh; a new one for the first cell that asks.
int TetrahedronBisection::middleOf(int a, int b, std::size_t mesh)
{
  const auto [found, isNew] = points_[mesh].try_emplace(edgeKey(a, b), meshes_[mesh].numPoints());
  if (isNew) {
    for (int k = 0; k < 3; ++k)
      meshes_[mesh].points.push_back(0.5 * (meshes_[mesh].point(a)[k] + meshes_[mesh].point(b)[k]));
    shared_[mesh].push_back(sharedMiddle(shared_[mesh][std::size_t(a)], shared_[mesh][std::size_t(b)]));
  }
  return found->second;
}

/// The vertex of the one mesh.
int TetrahedronBisection::sharedMiddle(int a, int b)
{
  const auto [found, isNew] = halved_.try_emplace(edgeKey(a, b), int(places_.size()));
  if (isNew) {
    places_.push_back(middle(places_[std::size_t(a)], places_[std::size_t(b)]));
    isEnd_.push_back(0);
    isEnd_[std::size_t(a)] = isEnd_[std::size_t(b)] = 1;
  }
  return found->second;
}

/// In the order in which the cells name them: whoever asked first has to do with the other bodies.
void TetrahedronBisection::numberNewPoints(std::size_t m, int numOld)
{
  Mesh& mesh = meshes_[m];
  std::vector<int> numbers(std::size_t(mesh.numPoints()), none);
  std::iota(numbers.begin(), numbers.begin() + numOld, 0);
  int next = numOld;
  for (Tetrahedron& cell : cells_[m])
    for (int& vertex : cell.vertices) {
      int& number = numbers[std::size_t(vertex)];
      if (number == none)
        number = next++;
      vertex = number;
    }
  const auto points = mesh.points;
  const auto shared = shared_[m];
  for (std::size_t p = std::size_t(numOld); p < shared.size(); ++p) {
    std::copy_n(points.begin() + 3 * std::ptrdiff_t(p), 3, mesh.points.begin() + 3 * std::ptrdiff_t(numbers[p]));
    shared_[m][std::size_t(numbers[p])] = shared[p];
  }
}

void TetrahedronBisection::writeMesh(std::size_t m)
{
  Mesh& mesh = meshes_[m];
  mesh.cells.clear();
  parents_[m].clear();
  const auto numFacets = std::size_t(numFacets_[m]); // in the parentheses below it would be a parameter for clang
  std::vector<std::vector<Facet>> parts(numFacets);
  for (const Tetrahedron& cell : cells_[m]) {
    for (int k = 0; k < 4; ++k)
      if (const int facet = cell.facets[std::size_t(k)]; facet != none)
        parts[std::size_t(facet)].push_back({int(parents_[m].size()), k});
    mesh.cells.insert(mesh.cells.end(), cell.vertices.begin(), cell.vertices.end());
    parents_[m].push_back(cell.parent);
  }
  mesh.groups.inherit(parents_[m]);
  for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
    mesh.sides[s].facets.clear();
    for (const int facet : sides_[m][s])
      for (const Facet part : parts[std::size_t(facet)])
        mesh.sides[s].facets.push_back(part);
  }
}

} // namespace ndframe
