// Cuts two solids whose meshes do not match at each other: afterwards they have common facets where they touch.
#include <cmath>

#include "ndframe/cutting/common_facets.hpp"
#include "ndframe/cutting/solid_sides.hpp"

int main()
{
  using namespace ndframe;
  // One tetrahedron stands on another one: the triangles between them have a quarter of the unit square in common.
  const Mesh upper{3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}, {{"bottom", {{0, 3}}}}, {}};
  const Mesh lower{3, {0, 0, 0, 1, 1, 0, 1, 0, 0, 1, 0, -1}, {0, 1, 2, 3}, {{"top", {{0, 3}}}}, {}};
  SolidSides pair;
  pair.firstBody = 0, pair.firstSide = "bottom";
  pair.secondBody = 1, pair.secondSide = "top";
  pair.isCut = true;
  const std::vector<DerivedMesh> cut = cutSolids({upper, lower}, {pair});

  bool ok = std::abs(overlappingArea(upper, upper.sides[0], lower, lower.sides[0]) - 0.25) < 1e-14;
  for (const DerivedMesh& body : cut) {
    double volume = 0.0;
    for (int cell = 0; cell < body.mesh.numCells(); ++cell)
      volume += cellMeasure(body.mesh, cell);
    ok = ok && checkMesh(body.mesh).empty() && std::abs(volume - 1.0 / 6.0) < 1e-14;
  }
  const Mesh &above = cut[0].mesh, &below = cut[1].mesh;
  const CommonFacets common = commonFacets(above, *above.findSide("bottom"), below, *below.findSide("top"));
  double area = 0.0, normal[3];
  for (const Facet facet : common.firstFacets)
    area += facetNormal(above, facet, normal);
  return ok && std::abs(area - 0.25) < 1e-14 ? 0 : 1;
}
