#include "ndframe/mesh/refined_share.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/mesh_parts.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

/// A mesh and where its points lie in the drawn one; the numbers of its cells in the whole mesh.
struct PlacedMesh
{
  Mesh mesh;
  std::vector<DrawnPlace> points;
  std::vector<RefinedNumbers::Number> cells;
};

/// These cells in this order, with their points in the order of the given ones.
PlacedMesh taken(const PlacedMesh& given, const std::vector<int>& cells, const std::vector<int>& points)
{
  PlacedMesh result{MeshParts(given.mesh).of(cells, points), {}, {}};
  for (const int cell : cells)
    result.cells.push_back(given.cells[std::size_t(cell)]);
  result.points.reserve(points.size());
  for (const int point : points)
    result.points.push_back(given.points[std::size_t(point)]);
  return result;
}

class Sharing
{
public:
  Sharing(const DrawnOwners& owners, int rank, const std::vector<std::string>& sides, bool withHalo)
      : owners_(owners), rank_(rank), sides_(sides), withHalo_(withHalo)
  {}

  /// The cells that are needed, with all that becomes of them where halvings follow.
  PlacedMesh cut(const PlacedMesh& given, bool isLast) const
  {
    std::vector<char> isNear = pointsOfSides(given.mesh, sides_), hasOwn(std::size_t(given.mesh.numCells()), 0);
    for (int cell = 0; cell < given.mesh.numCells(); ++cell) {
      const int* v = given.mesh.cell(cell);
      hasOwn[std::size_t(cell)] = char(hasOwnNode(given, v, isLast ? 2 : given.mesh.dim + 1));
      for (int i = 0; withHalo_ && hasOwn[std::size_t(cell)] != 0 && i <= given.mesh.dim; ++i)
        isNear[std::size_t(v[i])] = 1;
    }
    std::vector<int> cells;
    for (int cell = 0; cell < given.mesh.numCells(); ++cell) {
      const int* v = given.mesh.cell(cell);
      if (hasOwn[std::size_t(cell)] != 0 ||
          std::any_of(v, v + given.mesh.dim + 1, [&](int point) { return isNear[std::size_t(point)] != 0; }))
        cells.push_back(cell);
    }
    return taken(given, cells, pointsOfCells(given.mesh, cells));
  }

private:
  /// Whether the rank owns what lies inside a vertex, an edge, ... of the cell, of at most so many vertices.
  bool hasOwnNode(const PlacedMesh& given, const int* cell, int most) const
  {
    const unsigned subsets = 1U << unsigned(given.mesh.dim + 1);
    for (unsigned subset = 1; subset < subsets; ++subset) {
      DrawnPlace inside;
      int size = 0;
      for (int v = 0; v <= given.mesh.dim; ++v)
        if ((subset >> unsigned(v) & 1U) != 0) {
          const DrawnPlace& place = given.points[std::size_t(cell[v])];
          inside = size++ == 0 ? place : DrawnPlace::middle(inside, place); // only its vertices count
        }
      if (size <= most && owners_.rankOf(inside) == rank_)
        return true;
    }
    return false;
  }

  const DrawnOwners& owners_;
  int rank_;
  const std::vector<std::string>& sides_;
  bool withHalo_;
};

PlacedMesh refined(const PlacedMesh& given)
{
  PlacedMesh result;
  std::vector<std::array<int, 2>> middles;
  result.mesh = refineUniformly(given.mesh, &middles);
  const int children = numChildren(given.mesh.dim);
  for (const RefinedNumbers::Number cell : given.cells)
    for (int child = 0; child < children; ++child)
      result.cells.push_back(cell * children + child);
  result.points.reserve(given.points.size() + middles.size());
  for (const DrawnPlace& place : given.points)
    result.points.push_back(place.doubled());
  for (const auto& [a, b] : middles)
    result.points.push_back(DrawnPlace::middle(given.points[std::size_t(a)], given.points[std::size_t(b)]));
  return result;
}

/// In the order that RefinedShare promises.
RefinedShare sorted(const PlacedMesh& given, const RefinedNumbers& numbers, const DrawnOwners& owners, int rank)
{
  std::vector<RefinedNumbers::Number> number;
  for (const DrawnPlace& place : given.points)
    number.push_back(numbers.point(place));
  std::vector<int> points(number.size()), cells(std::size_t(given.mesh.numCells()));
  std::iota(points.begin(), points.end(), 0);
  std::sort(points.begin(), points.end(),
            [&](int a, int b) { return number[std::size_t(a)] < number[std::size_t(b)]; });
  std::iota(cells.begin(), cells.end(), 0);
  std::vector<int> owner;
  for (const int cell : cells) {
    const int* v = given.mesh.cell(cell);
    const int lowest = *std::min_element(v, v + given.mesh.dim + 1,
                                         [&](int a, int b) { return number[std::size_t(a)] < number[std::size_t(b)]; });
    owner.push_back(owners.rankOf(given.points[std::size_t(lowest)]));
  }
  const auto others =
      std::stable_partition(cells.begin(), cells.end(), [&](int cell) { return owner[std::size_t(cell)] == rank; });
  PlacedMesh ordered = taken(given, cells, points);
  std::sort(number.begin(), number.end());
  std::vector<int> ranks;
  for (const int cell : cells)
    ranks.push_back(owner[std::size_t(cell)]);
  return {std::move(ordered.mesh),  std::move(ordered.points), std::move(number),
          std::move(ordered.cells), std::move(ranks),          int(others - cells.begin())};
}

} // namespace

std::vector<char> pointsOfSides(const Mesh& mesh, const std::vector<std::string>& sides)
{
  std::vector<char> touches(std::size_t(mesh.numPoints()), 0);
  int vertices[3];
  for (const std::string& name : sides)
    for (const Facet facet : mesh.findSide(name)->facets) {
      facetVertices(mesh, facet, vertices);
      for (int v = 0; v < mesh.dim; ++v)
        touches[std::size_t(vertices[v])] = 1;
    }
  return touches;
}

int DrawnOwners::rankOf(const DrawnPlace& place) const
{
  const auto first = place.vertices.begin();
  return ranks[std::size_t(*std::min_element(
      first, first + place.count, [this](int a, int b) { return order[std::size_t(a)] < order[std::size_t(b)]; }))];
}

RefinedShare refinedShare(const Mesh& drawn, int halvings, const RefinedNumbers& numbers, const DrawnOwners& owners,
                          int rank, const std::vector<std::string>& sides, bool withHalo)
{
  NDFRAME_ASSERT(std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return drawn.findSide(side); }),
                 "the drawn mesh has the sides that all ranks have");
  PlacedMesh mesh{drawn, {}, {}};
  for (int cell = 0; cell < drawn.numCells(); ++cell)
    mesh.cells.push_back(numbers.cell(cell));
  for (int point = 0; point < drawn.numPoints(); ++point)
    mesh.points.push_back(DrawnPlace::vertex(point));
  const Sharing sharing(owners, rank, sides, withHalo);
  mesh = sharing.cut(mesh, halvings == 0);
  for (int k = 1; k <= halvings; ++k)
    mesh = sharing.cut(refined(mesh), k == halvings);
  return sorted(mesh, numbers, owners, rank);
}

} // namespace ndframe
