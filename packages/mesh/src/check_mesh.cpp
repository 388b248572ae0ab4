#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/mesh/mesh.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// What the rounding of coordinates may be of an edge: stresses have about as many digits as the edges.
constexpr double coarsestResolution = 1e-6;

/// Counts one kind of mistake and remembers the first case.
struct Tally
{
  int count = 0;
  int first = -1;

  void add(int which)
  {
    if (count++ == 0)
      first = which;
  }
};

std::string cellPosition(const Mesh& mesh, int cell)
{
  std::vector<double> centre(mesh.dim, 0.0);
  for (int k = 0; k <= mesh.dim; ++k)
    for (int i = 0; i < mesh.dim; ++i)
      centre[i] += mesh.point(mesh.cell(cell)[k])[i] / (mesh.dim + 1);
  return fmt::format("({:.6g})", fmt::join(centre, ", "));
}

/// Of a cell's edges, and the largest coordinate of its vertices.
struct CellSize
{
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity(), coordinate = 0.0;
};

CellSize sizeOf(const Mesh& mesh, int cell)
{
  CellSize size;
  for (int a = 0; a <= mesh.dim; ++a)
    for (int b = 0; b < a; ++b) {
      double squares = 0.0;
      for (int i = 0; i < mesh.dim; ++i) {
        const double d = mesh.point(mesh.cell(cell)[a])[i] - mesh.point(mesh.cell(cell)[b])[i];
        squares += d * d;
      }
      const double edge = std::sqrt(squares);
      size.longest = std::max(size.longest, edge);
      size.shortest = std::min(size.shortest, edge);
    }
  for (int a = 0; a <= mesh.dim; ++a)
    for (int i = 0; i < mesh.dim; ++i)
      size.coordinate = std::max(size.coordinate, std::abs(mesh.point(mesh.cell(cell)[a])[i]));
  return size;
}

/// Mistakes that make every further question about the mesh meaningless.
std::vector<std::string> checkArrays(const Mesh& mesh)
{
  if (mesh.dim != 2 && mesh.dim != 3)
    return {fmt::format("the mesh has dimension {}; 2 and 3 are possible.", mesh.dim)};
  if (mesh.numCells() == 0)
    return {"the mesh has no cells."};
  std::vector<std::string> mistakes;
  const auto outside = [&](int v) { return v < 0 || v >= mesh.numPoints(); };
  const auto wrong = std::find_if(mesh.cells.begin(), mesh.cells.end(), outside);
  if (wrong != mesh.cells.end())
    mistakes.push_back(fmt::format("cell {} names the vertex {}, but the mesh has only {} points.",
                                   (wrong - mesh.cells.begin()) / (mesh.dim + 1), *wrong, mesh.numPoints()));
  const auto infinite =
      std::find_if(mesh.points.begin(), mesh.points.end(), [](double x) { return !std::isfinite(x); });
  if (infinite != mesh.points.end())
    mistakes.push_back(
        fmt::format("point {} has a coordinate that is not finite.", (infinite - mesh.points.begin()) / mesh.dim));
  return mistakes;
}

/// Returns true when all cells are positively oriented.
bool checkCells(const Mesh& mesh, std::vector<std::string>& mistakes)
{
  Tally inverted;
  Tally degenerate;
  Tally unresolved;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const double measure = cellMeasure(mesh, c);
    const CellSize size = sizeOf(mesh, c);
    const double h = size.longest;
    const double roundOff = 4 * epsilon * (mesh.dim == 2 ? h * h : h * h * h);
    if (std::abs(measure) <= roundOff)
      degenerate.add(c);
    else if (measure < 0.0)
      inverted.add(c);
    else if (epsilon * size.coordinate > coarsestResolution * size.shortest)
      unresolved.add(c);
  }
  for (const auto& [tally, what] : {std::pair{inverted, "inverted"}, std::pair{degenerate, "degenerate (flat)"}})
    if (tally.count > 0)
      mistakes.push_back(fmt::format("{} of {} cells are {}; the first is cell {} at {}.", tally.count, mesh.numCells(),
                                     what, tally.first, cellPosition(mesh, tally.first)));
  if (unresolved.count > 0)
    mistakes.push_back(
        fmt::format("{} of {} cells are too small so far from the origin, their coordinates are rounded to fewer than "
                    "six digits of an edge; the first is cell {} at {}; move the mesh towards the origin.",
                    unresolved.count, mesh.numCells(), unresolved.first, cellPosition(mesh, unresolved.first)));
  return inverted.count + degenerate.count == 0;
}

void checkPoints(const Mesh& mesh, std::vector<std::string>& mistakes)
{
  std::vector<bool> used(mesh.numPoints(), false);
  for (const int v : mesh.cells)
    used[v] = true;
  Tally unused;
  for (int p = 0; p < mesh.numPoints(); ++p)
    if (!used[p])
      unused.add(p);
  if (unused.count > 0)
    mistakes.push_back(fmt::format("{} points belong to no cell; the first is point {}.", unused.count, unused.first));
}

/// +1 or -1: orientation of a facet seen from its cell, as the parity of its vertices. Two positively oriented cells
/// lie on different sides of a common facet exactly if the values differ.
int facetParity(const Mesh& mesh, int facetNumber)
{
  const int facets = mesh.dim + 1;
  const Facet facet{facetNumber / facets, facetNumber % facets};
  int v[3];
  facetVertices(mesh, facet, v);
  int sign = facet.local % 2 == 0 ? 1 : -1;
  for (int a = 0; a < mesh.dim; ++a)
    for (int b = 0; b < a; ++b)
      sign = v[b] > v[a] ? -sign : sign;
  return sign;
}

/// Checks how cells meet (overlaps only if all cells are positively oriented); returns for every facet whether it lies
/// on the boundary.
std::vector<bool> checkFacets(const Mesh& mesh, bool allPositive, std::vector<std::string>& mistakes)
{
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  std::vector<bool> onBoundary(facets.size(), false);
  Tally crowded;
  Tally folded;
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    const int first = facets.at(place);
    onBoundary[first] = end - place == 1;
    if (end - place > 2)
      crowded.add(first / (mesh.dim + 1));
    else if (end - place == 2 && facetParity(mesh, first) == facetParity(mesh, facets.at(place + 1)))
      folded.add(first / (mesh.dim + 1));
  }
  if (crowded.count > 0)
    mistakes.push_back(fmt::format("{} facets are shared by more than two cells; the first is one of cell {} at {}.",
                                   crowded.count, crowded.first, cellPosition(mesh, crowded.first)));
  if (allPositive && folded.count > 0)
    mistakes.push_back(fmt::format("{} facets have both their cells on the same side, so these overlap (or are listed "
                                   "twice); the first is one of cell {} at {}.",
                                   folded.count, folded.first, cellPosition(mesh, folded.first)));
  return onBoundary;
}

void checkSide(const Mesh& mesh, const Side& side, const std::vector<bool>& onBoundary,
               std::vector<std::string>& mistakes)
{
  const int facets = mesh.dim + 1;
  Tally inside;
  std::vector<int> seen;
  for (const Facet& facet : side.facets) {
    if (facet.cell < 0 || facet.cell >= mesh.numCells() || facet.local < 0 || facet.local >= facets) {
      mistakes.push_back(fmt::format("side \"{}\" names facet {} of cell {}, which does not exist.", side.name,
                                     facet.local, facet.cell));
      return;
    }
    seen.push_back(facets * facet.cell + facet.local);
    if (!onBoundary[seen.back()])
      inside.add(facet.cell);
  }
  if (inside.count > 0)
    mistakes.push_back(fmt::format("{} facets of side \"{}\" are not on the boundary; the first is one of cell {} at "
                                   "{}.",
                                   inside.count, side.name, inside.first, cellPosition(mesh, inside.first)));
  std::sort(seen.begin(), seen.end());
  if (std::adjacent_find(seen.begin(), seen.end()) != seen.end())
    mistakes.push_back(fmt::format("side \"{}\" lists a facet twice.", side.name));
}

} // namespace

std::vector<std::string> checkMesh(const Mesh& mesh)
{
  std::vector<std::string> mistakes = checkArrays(mesh);
  if (!mistakes.empty())
    return mistakes;
  const bool allPositive = checkCells(mesh, mistakes);
  checkPoints(mesh, mistakes);
  const std::vector<bool> onBoundary = checkFacets(mesh, allPositive, mistakes);
  for (const Side& side : mesh.sides) {
    if (mesh.findSide(side.name) != &side)
      mistakes.push_back(fmt::format("two sides are called \"{}\".", side.name));
    checkSide(mesh, side, onBoundary, mistakes);
  }
  return mistakes;
}

} // namespace ndframe
