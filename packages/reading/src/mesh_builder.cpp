#include "mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/mesh/vertex_tuples.hpp"
#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

/// Edges whose middle node lies further from the straight middle than this part of their length count as curved; files
/// in single precision stay below.
constexpr double curvedTolerance = 1e-6;

} // namespace

MeshBuilder::MeshBuilder(int dim, std::vector<double> coordinates) : coordinates_(std::move(coordinates))
{
  mesh_.dim = dim;
}

double MeshBuilder::distanceFromMiddle(int mid, int a, int b) const
{
  const double* x = coordinates_.data();
  double move = 0.0;
  double length = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double along = x[3 * b + i] - x[3 * a + i];
    const double off = x[3 * mid + i] - x[3 * a + i] - along / 2;
    move += off * off;
    length += along * along;
  }
  return move > curvedTolerance * curvedTolerance * length ? std::sqrt(move) : 0.0;
}

void MeshBuilder::addCells(const std::vector<int>& nodes, int nodesPerCell, const std::vector<std::int64_t>& numbers,
                           const MidNodes& midNodes, std::vector<std::string> groups)
{
  const int vertices = mesh_.dim + 1;
  if (nodesPerCell > vertices)
    seenMid_.resize(std::size_t(numNodes()), false);
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    const int* cell = nodes.data() + c * std::size_t(nodesPerCell);
    mesh_.cells.insert(mesh_.cells.end(), cell, cell + vertices);
    for (int k = vertices; k < nodesPerCell; ++k) {
      if (seenMid_[cell[k]])
        continue;
      seenMid_[cell[k]] = true;
      const auto [a, b] = midNodes[k - vertices];
      const double move = distanceFromMiddle(cell[k], cell[a], cell[b]);
      curvedEdges_ += move > 0.0 ? 1 : 0;
      largestMove_ = std::max(largestMove_, move);
    }
  }
  numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  mesh_.groups.kind.resize(numbers_.size(), mesh_.groups.findOrAdd(std::move(groups)));
}

void MeshBuilder::dropRepeatedCells()
{
  const int vertices = mesh_.dim + 1;
  const VertexTuples sorted(mesh_.cells, vertices, numNodes());
  std::vector<bool> keep(numbers_.size(), false);
  for (int place = 0, end = 0; place < sorted.size(); place = end) {
    end = sorted.groupEnd(place);
    keep[sorted.at(place)] = true;
    joinGroups(sorted, place, end);
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < keep.size(); ++c) {
    if (!keep[c])
      continue;
    std::copy_n(mesh_.cells.begin() + c * vertices, vertices, mesh_.cells.begin() + kept * vertices);
    mesh_.groups.kind[kept] = mesh_.groups.kind[c];
    numbers_[kept++] = numbers_[c];
  }
  mesh_.groups.kind.resize(kept);
  numbers_.resize(kept);
  mesh_.cells.resize(kept * vertices);
}

/// The first of equal cells gets the groups of all.
void MeshBuilder::joinGroups(const VertexTuples& cells, int first, int end)
{
  std::vector<std::string> joined;
  for (int place = first; place < end && end > first + 1; ++place) {
    const auto& names = mesh_.groups.names[std::size_t(mesh_.groups.kind[std::size_t(cells.at(place))])];
    joined.insert(joined.end(), names.begin(), names.end());
  }
  if (end > first + 1)
    mesh_.groups.kind[std::size_t(cells.at(first))] = mesh_.groups.findOrAdd(std::move(joined));
}

void MeshBuilder::addSide(std::string name, std::vector<Facet> facets)
{
  const auto key = [](const Facet& f) { return std::pair{f.cell, f.local}; };
  std::sort(facets.begin(), facets.end(), [&](const Facet& a, const Facet& b) { return key(a) < key(b); });
  facets.erase(
      std::unique(facets.begin(), facets.end(), [&](const Facet& a, const Facet& b) { return key(a) == key(b); }),
      facets.end());
  mesh_.sides.push_back({std::move(name), std::move(facets)});
}

void MeshBuilder::dropUnusedPoints()
{
  std::vector<int> renumbered(std::size_t(numNodes()), -1);
  for (const int v : mesh_.cells)
    renumbered[v] = 0;
  int used = 0;
  for (int& number : renumbered)
    number = number == 0 ? used++ : -1;
  mesh_.points.resize(std::size_t(used) * std::size_t(mesh_.dim));
  for (int node = 0; node < numNodes(); ++node)
    for (int i = 0; i < mesh_.dim && renumbered[node] >= 0; ++i)
      mesh_.points[std::size_t(renumbered[node]) * std::size_t(mesh_.dim) + std::size_t(i)] =
          coordinates_[3 * std::size_t(node) + std::size_t(i)];
  for (int& v : mesh_.cells)
    v = renumbered[v];
}

void MeshBuilder::requirePlane() const
{
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY};
  std::array<double, 3> high{-INFINITY, -INFINITY, -INFINITY};
  for (const int v : mesh_.cells)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], coordinates_[3 * v + i]);
      high[i] = std::max(high[i], coordinates_[3 * v + i]);
    }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  if (high[2] - low[2] > 1e-9 * extent)
    throw FileError(
        fmt::format("the triangles do not lie in a plane z = constant (z goes from {} to {}).", low[2], high[2]));
}

void MeshBuilder::orient()
{
  int positive = 0;
  int negative = 0;
  int firstNegative = -1;
  for (int c = 0; c < mesh_.numCells(); ++c) {
    const double measure = cellMeasure(mesh_, c);
    positive += measure > 0.0 ? 1 : 0;
    if (measure < 0.0 && negative++ == 0)
      firstNegative = c;
  }
  if (negative > 0 && positive > 0)
    failInverted(negative, firstNegative);
  if (negative > 0)
    turnAround();
}

void MeshBuilder::failInverted(int count, int first) const
{
  std::vector<double> centre(mesh_.dim, 0.0);
  for (int k = 0; k <= mesh_.dim; ++k)
    for (int i = 0; i < mesh_.dim; ++i)
      centre[i] += mesh_.point(mesh_.cell(first)[k])[i] / (mesh_.dim + 1);
  throw FileError(fmt::format("{} of {} elements are inverted; the first is element {} at ({:.6g}).", count,
                              mesh_.numCells(), numbers_[first], fmt::join(centre, ", ")));
}

void MeshBuilder::turnAround()
{
  for (int c = 0; c < mesh_.numCells(); ++c)
    std::swap(mesh_.cells[std::size_t(c) * (mesh_.dim + 1)], mesh_.cells[std::size_t(c) * (mesh_.dim + 1) + 1]);
  for (Side& side : mesh_.sides)
    for (Facet& facet : side.facets)
      facet.local = facet.local < 2 ? 1 - facet.local : facet.local;
  addNote("All elements were negatively oriented and have been reoriented.");
}

void MeshBuilder::noteCurvedEdges()
{
  if (curvedEdges_ > 0)
    addNote(fmt::format("{} curved edges have been straightened; their middle nodes moved by up to {:.3g}.",
                        curvedEdges_, largestMove_));
}

Mesh MeshBuilder::finish()
{
  if (mesh_.dim == 2)
    requirePlane();
  dropUnusedPoints();
  if (!mesh_.points.empty()) { // sin(pi) of a script is meant to be zero
    const auto [low, high] = std::minmax_element(mesh_.points.begin(), mesh_.points.end());
    dropRoundOff(mesh_.points, *high - *low);
  }
  orient();
  noteCurvedEdges();
  if (mesh_.groups.names == std::vector<std::vector<std::string>>{{}})
    mesh_.groups = {}; // none has a name
  const std::vector<std::string> mistakes = checkMesh(mesh_);
  if (!mistakes.empty())
    throw FileError(fmt::format("{}", fmt::join(mistakes, " ")));
  return std::move(mesh_);
}

} // namespace ndframe
