#include <algorithm>

#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

SortedCell sortedCell(const Mesh& mesh, int cell)
{
  SortedCell sorted;
  for (int local = 0; local <= mesh.dim; ++local) {
    const auto place = std::size_t(sortedFacet(mesh, {cell, local}));
    sorted.vertices[place] = mesh.cell(cell)[local];
    sorted.local[place] = local;
  }
  return sorted;
}

int sortedFacet(const Mesh& mesh, Facet facet)
{
  const int* vertices = mesh.cell(facet.cell);
  const int opposite = vertices[facet.local];
  return int(std::count_if(vertices, vertices + mesh.dim + 1, [opposite](int v) { return v < opposite; }));
}

} // namespace ndframe
