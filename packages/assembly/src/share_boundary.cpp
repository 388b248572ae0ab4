#include "ndframe/assembly/share_boundary.hpp"

#include <algorithm>
#include <map>

namespace ndframe
{
namespace
{

using Global = BodyShare::Global;
using Vertices = std::array<Global, 3>; ///< of a facet, ascending; in the plane the last is none

Vertices verticesOf(const Mesh& mesh, const BodyShare& share, const int* vertices)
{
  Vertices numbers{-1, -1, -1};
  for (int v = 0; v < mesh.dim; ++v)
    numbers[std::size_t(v)] = share.numbers()[std::size_t(vertices[v])];
  std::sort(numbers.begin(), numbers.begin() + mesh.dim);
  return numbers;
}

/// Per rank and facet that it tells of, whether nobody else does.
std::vector<std::vector<Global>> areAlone(const std::vector<std::vector<Global>>& told)
{
  std::map<Vertices, int> cells;
  const auto forEach = [&](const std::vector<Global>& numbers, const auto& visit) {
    for (std::size_t at = 0; at < numbers.size(); at += 3)
      visit(cells[{numbers[at], numbers[at + 1], numbers[at + 2]}]);
  };
  for (const auto& numbers : told)
    forEach(numbers, [](int& count) { ++count; });
  std::vector<std::vector<Global>> answers(told.size());
  for (std::size_t rank = 0; rank < told.size(); ++rank)
    forEach(told[rank], [&](int count) { answers[rank].push_back(count == 1 ? 1 : 0); });
  return answers;
}

} // namespace

std::vector<Facet> ownBoundary(const Mesh& mesh, const BodyShare& share, const Comm& comm)
{
  Mesh own;
  own.dim = mesh.dim;
  own.points = mesh.points;
  own.cells.assign(mesh.cells.begin(), mesh.cells.begin() + std::ptrdiff_t(share.numOwnCells()) * (mesh.dim + 1));
  if (comm.size() == 1)
    return boundaryFacets(own);
  std::vector<std::vector<Global>> told(std::size_t(comm.size()));
  std::vector<std::vector<Facet>> facets(told.size());
  for (const Facet facet : boundaryFacets(own)) {
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    const auto owner = std::size_t(share.owners()[std::size_t(*std::min_element(vertices, vertices + mesh.dim))]);
    const Vertices numbers = verticesOf(mesh, share, vertices);
    told[owner].insert(told[owner].end(), numbers.begin(), numbers.end());
    facets[owner].push_back(facet);
  }
  const auto answers = askedFor(areAlone(askedFor(told, comm)), comm);
  std::vector<Facet> boundary;
  for (std::size_t rank = 0; rank < facets.size(); ++rank)
    for (std::size_t f = 0; f < facets[rank].size(); ++f)
      if (answers[rank][f] != 0)
        boundary.push_back(facets[rank][f]);
  std::sort(boundary.begin(), boundary.end(),
            [](Facet a, Facet b) { return std::pair(a.cell, a.local) < std::pair(b.cell, b.local); });
  return boundary;
}

} // namespace ndframe
