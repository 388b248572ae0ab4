#include "ndframe/mesh/numbered_mesh.hpp"

#include <algorithm>

#include "ndframe/base/ascending.hpp"
#include "ndframe/mesh/byte_stream.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"
#include "ndframe/mesh/mesh_parts.hpp"

namespace ndframe
{
namespace
{

using Number = std::int64_t;

/// The numbers of all parts, each once.
std::vector<Number> numbersOf(const std::vector<NumberedMesh>& parts, std::vector<Number> NumberedMesh::*kind)
{
  std::vector<Number> numbers;
  for (const NumberedMesh& part : parts)
    numbers.insert(numbers.end(), (part.*kind).begin(), (part.*kind).end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<int> placesOf(const std::vector<Number>& numbers, const std::vector<Number>& all)
{
  std::vector<int> places;
  for (const Number number : numbers)
    places.push_back(placeOf(all, number));
  return places;
}

/// Adds a part to the mesh that has room for it.
void add(const NumberedMesh& part, NumberedMesh& all)
{
  const auto dim = std::size_t(all.mesh.dim), vertices = dim + 1;
  const std::vector<int> pointOf = placesOf(part.points, all.points), cellOf = placesOf(part.cells, all.cells);
  for (int point = 0; point < part.mesh.numPoints(); ++point)
    std::copy_n(part.mesh.point(point), dim, &all.mesh.points[std::size_t(pointOf[std::size_t(point)]) * dim]);
  for (int cell = 0; cell < part.mesh.numCells(); ++cell)
    for (std::size_t v = 0; v < vertices; ++v)
      all.mesh.cells[std::size_t(cellOf[std::size_t(cell)]) * vertices + v] =
          pointOf[std::size_t(part.mesh.cell(cell)[v])];
  NDFRAME_ASSERT(part.mesh.groups.names == all.mesh.groups.names, "parts of a mesh have all its groups");
  for (std::size_t cell = 0; cell < part.mesh.groups.kind.size(); ++cell)
    all.mesh.groups.kind[std::size_t(cellOf[cell])] = part.mesh.groups.kind[cell];
  NDFRAME_ASSERT(part.mesh.sides.size() == all.mesh.sides.size(), "parts of a mesh have all its sides");
  for (std::size_t s = 0; s < part.mesh.sides.size(); ++s) {
    const Side& side = part.mesh.sides[s];
    NDFRAME_ASSERT(side.name == all.mesh.sides[s].name, "parts of a mesh have all its sides in one order");
    for (const Facet facet : side.facets)
      all.mesh.sides[s].facets.push_back({cellOf[std::size_t(facet.cell)], facet.local});
  }
}

void sortFacets(Side& side)
{
  const auto key = [](const Facet& facet) { return std::pair(facet.cell, facet.local); };
  std::sort(side.facets.begin(), side.facets.end(), [&](Facet a, Facet b) { return key(a) < key(b); });
  const auto last =
      std::unique(side.facets.begin(), side.facets.end(), [&](Facet a, Facet b) { return key(a) == key(b); });
  side.facets.erase(last, side.facets.end());
}

/// In one order for both directions.
template <class Stream, class Part>
void walkNumbers(Stream& stream, Part& part)
{
  stream.array(part.points);
  stream.array(part.cells);
}

} // namespace

NumberedMesh NumberedMesh::with(const std::vector<int>& taken) const
{
  const std::vector<int> vertices = pointsOfCells(mesh, taken);
  NumberedMesh part{MeshParts(mesh).of(taken, vertices), {}, {}};
  for (const int point : vertices)
    part.points.push_back(points[std::size_t(point)]);
  for (const int cell : taken)
    part.cells.push_back(cells[std::size_t(cell)]);
  return part;
}

NumberedMesh joined(const std::vector<NumberedMesh>& parts)
{
  NDFRAME_ASSERT(!parts.empty(), "there are parts");
  NumberedMesh all;
  all.points = numbersOf(parts, &NumberedMesh::points);
  all.cells = numbersOf(parts, &NumberedMesh::cells);
  all.mesh.dim = parts.front().mesh.dim;
  all.mesh.points.resize(all.points.size() * std::size_t(all.mesh.dim));
  all.mesh.cells.resize(all.cells.size() * std::size_t(all.mesh.dim + 1));
  for (const Side& side : parts.front().mesh.sides)
    all.mesh.sides.push_back({side.name, {}});
  all.mesh.groups.names = parts.front().mesh.groups.names;
  all.mesh.groups.kind.resize(all.mesh.groups.names.empty() ? 0 : all.cells.size());
  for (const NumberedMesh& part : parts)
    add(part, all);
  for (Side& side : all.mesh.sides)
    sortFacets(side);
  return all;
}

std::string toBytes(const NumberedMesh& part)
{
  ByteWriter writer;
  writer.array(toBytes(part.mesh));
  walkNumbers(writer, part);
  return writer.take();
}

NumberedMesh numberedMeshFromBytes(std::string_view bytes)
{
  ByteReader reader(bytes);
  std::string ofMesh;
  reader.array(ofMesh);
  NumberedMesh part{meshFromBytes(ofMesh), {}, {}};
  walkNumbers(reader, part);
  reader.requireEnd();
  return part;
}

} // namespace ndframe
