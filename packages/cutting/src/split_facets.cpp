#include "ndframe/cutting/split_facets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/cutting/cannot_cut.hpp"

namespace ndframe
{
namespace
{

/// Divided cells fill the space that they filled, up to round-off.
constexpr double sameVolume = 1e-10;
/// Of a cell whose vertices have moved, relative to what it was.
constexpr double smallestVolume = 0.2;

using Edge = std::array<int, 2>;
using Triangle = FacetSplits::Triangle;

Edge edgeOf(int a, int b)
{
  return {std::min(a, b), std::max(a, b)};
}

/// Replaces the triangle that has the edge between the ends of a chain by a fan around its third vertex.
void fan(std::vector<Triangle>& parts, const std::vector<int>& chain)
{
  const auto has = [](const Triangle& part, int v) { return std::find(part.begin(), part.end(), v) != part.end(); };
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Triangle& part) {
    return has(part, chain.front()) && has(part, chain.back());
  });
  NDFRAME_ASSERT(found != parts.end(), "a divided facet lost an edge");
  const int apex =
      *std::find_if(found->begin(), found->end(), [&](int v) { return v != chain.front() && v != chain.back(); });
  *found = {chain[0], chain[1], apex};
  for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    parts.push_back({chain[i], chain[i + 1], apex});
}

class Splitter
{
public:
  Splitter(const Mesh& mesh, const FacetSplits& splits)
      : old_(mesh), splits_(splits), result_{mesh, std::vector<int>(std::size_t(mesh.numCells()))}
  {
    std::iota(result_.parents.begin(), result_.parents.end(), 0);
    result_.mesh.points.insert(result_.mesh.points.end(), splits.points.begin(), splits.points.end());
    for (const auto& [vertex, to] : splits.moved)
      std::copy(to.begin(), to.end(), result_.mesh.points.begin() + std::ptrdiff_t(vertex) * 3);
  }

  DerivedMesh run()
  {
    std::vector<char> isEnd(std::size_t(old_.numPoints()), 0);
    const auto mark = [&](const auto& vertices) {
      for (const int vertex : vertices)
        isEnd[std::size_t(vertex)] = 1;
    };
    for (const auto& [edge, points] : splits_.edges)
      mark(edge);
    for (const auto& [facet, triangles] : splits_.facets)
      mark(verticesOf({facet.first, facet.second}));
    for (const auto& [vertex, to] : splits_.moved)
      mark(std::array<int, 1>{vertex});
    for (int cell = 0; cell < old_.numCells(); ++cell) {
      const int* v = old_.cell(cell);
      const auto ends = std::count_if(v, v + 4, [&](int vertex) { return isEnd[std::size_t(vertex)] != 0; });
      if (ends > 1 && isDivided(cell))
        divide(cell);
      else if (ends > 0)
        keep(cell);
    }
    if (std::abs(newVolume_ - oldVolume_) > sameVolume * oldVolume_)
      throw CannotCut("divided cells turn over");
    for (std::size_t s = 0; s < old_.sides.size(); ++s)
      divideSide(old_.sides[s], result_.mesh.sides[s]);
    result_.mesh.groups.inherit(result_.parents);
    return std::move(result_);
  }

private:
  Triangle verticesOf(Facet facet) const
  {
    Triangle vertices{};
    facetVertices(old_, facet, vertices.data());
    return vertices;
  }

  bool isEdgeDivided(int a, int b) const { return splits_.edges.count(edgeOf(a, b)) > 0; }

  bool isFacetDivided(Facet facet) const
  {
    const Triangle v = verticesOf(facet);
    return splits_.facets.count({facet.cell, facet.local}) > 0 || isEdgeDivided(v[0], v[1]) ||
           isEdgeDivided(v[1], v[2]) || isEdgeDivided(v[0], v[2]);
  }

  bool isDivided(int cell) const
  {
    for (int local = 0; local < 4; ++local)
      if (isFacetDivided({cell, local}))
        return true;
    return false;
  }

  std::vector<Triangle> trianglesOf(Facet facet) const
  {
    if (const auto known = splits_.facets.find({facet.cell, facet.local}); known != splits_.facets.end())
      return known->second;
    const Triangle v = verticesOf(facet);
    std::vector<Triangle> parts{v};
    std::array<Edge, 3> edges{edgeOf(v[0], v[1]), edgeOf(v[1], v[2]), edgeOf(v[0], v[2])};
    std::sort(edges.begin(), edges.end());
    for (const Edge& edge : edges)
      if (const auto found = splits_.edges.find(edge); found != splits_.edges.end()) {
        std::vector<int> chain{edge[0]};
        chain.insert(chain.end(), found->second.begin(), found->second.end());
        chain.push_back(edge[1]);
        fan(parts, chain);
      }
    return parts;
  }

  /// The vertex opposite to a facet that alone is divided: the other ones then are fans around it.
  std::optional<int> apexOf(int cell) const
  {
    const int* v = old_.cell(cell);
    for (int local = 0; local < 4; ++local) {
      bool isApex = true;
      for (int other = 0; other < 4; ++other)
        isApex = isApex &&
                 (other == local || (splits_.facets.count({cell, other}) == 0 && !isEdgeDivided(v[local], v[other])));
      if (isApex)
        return local;
    }
    return std::nullopt;
  }

  /// A cell of which only vertices may have moved.
  void keep(int cell)
  {
    const double before = cellMeasure(old_, cell), now = cellMeasure(result_.mesh, cell);
    if (now < smallestVolume * before)
      throw CannotCut("a cell is squeezed by vertices that have moved");
    oldVolume_ += before;
    newVolume_ += now;
  }

  void divide(int cell)
  {
    const auto local = apexOf(cell);
    int apex = 0;
    std::vector<int> facets;
    if (local) {
      apex = old_.cell(cell)[*local];
      facets.push_back(*local);
    } else {
      apex = result_.mesh.numPoints();
      const auto centre = cellCentre(old_, cell);
      result_.mesh.points.insert(result_.mesh.points.end(), centre.begin(), centre.end());
      facets = {0, 1, 2, 3};
    }
    oldVolume_ += cellMeasure(old_, cell);
    auto& numbers = partsOf_[cell];
    for (const int facet : facets)
      for (const Triangle& base : trianglesOf({cell, facet}))
        addPart(cell, base, apex, numbers);
  }

  void addPart(int cell, const Triangle& base, int apex, std::vector<int>& numbers)
  {
    Mesh& mesh = result_.mesh;
    const int number = numbers.empty() ? cell : mesh.numCells();
    numbers.push_back(number);
    if (number != cell) {
      mesh.cells.resize(mesh.cells.size() + 4);
      result_.parents.push_back(cell);
    }
    int* vertices = mesh.cells.data() + std::ptrdiff_t(number) * 4;
    std::copy(base.begin(), base.end(), vertices);
    vertices[3] = apex;
    const double volume = cellMeasure(mesh, number);
    if (volume < 0.0)
      std::swap(vertices[0], vertices[1]);
    newVolume_ += std::abs(volume);
  }

  void divideSide(const Side& old, Side& side) const
  {
    side.facets.clear();
    for (const Facet facet : old.facets) {
      const auto parts = partsOf_.find(facet.cell);
      if (parts == partsOf_.end()) {
        side.facets.push_back(facet);
        continue;
      }
      for (const Triangle& triangle : trianglesOf(facet))
        side.facets.push_back(findPart(parts->second, triangle));
    }
  }

  /// Which part of a cell has a triangle.
  Facet findPart(const std::vector<int>& parts, const Triangle& triangle) const
  {
    for (const int part : parts) {
      const int* v = result_.mesh.cell(part);
      const auto isOf = [&](int vertex) {
        return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
      };
      if (std::count_if(v, v + 4, isOf) == 3)
        return {part, int(std::find_if_not(v, v + 4, isOf) - v)};
    }
    throw CannotCut("a divided cell lost a facet");
  }

  const Mesh& old_;
  const FacetSplits& splits_;
  DerivedMesh result_;
  double oldVolume_ = 0.0, newVolume_ = 0.0; ///< of the cells that are divided
  std::map<int, std::vector<int>> partsOf_;  ///< of the cells that are divided: their parts
};

} // namespace

DerivedMesh splitFacets(const Mesh& mesh, const FacetSplits& splits)
{
  NDFRAME_ASSERT(mesh.dim == 3, "facets of tetrahedra are divided");
  return Splitter(mesh, splits).run();
}

} // namespace ndframe
