// Bisects two squares that share a side where one of them is to be fine: the meshes stay sound and go on matching.
#include <cmath>

#include "ndframe/mesh/bisection.hpp"
#include "ndframe/mesh/shape.hpp"

int main()
{
  using namespace ndframe;
  // Facet k of a cell is opposite to its vertex k.
  const Mesh lower{2, {0, 0, 1, 0, 1, 1, 0, 1}, {0, 1, 2, 0, 2, 3}, {{"top", {{1, 0}}}}, {}};
  const Mesh upper{2, {0, 1, 1, 1, 1, 2, 0, 2}, {0, 1, 2, 0, 2, 3}, {{"bottom", {{0, 2}}}}, {}};
  Bisection bisection({lower, upper}, {{0, {1, 0}, 1, {0, 2}}});
  bisection.refine({{0, 0}, {6, 0}}); // halves one cell of the upper square six times

  bool ok = true;
  for (const Mesh& mesh : bisection.meshes()) {
    double area = 0.0;
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      area += cellMeasure(mesh, cell);
    // Half squares have no descendants of another shape.
    ok = ok && checkMesh(mesh).empty() && std::abs(area - 1.0) < 1e-14 &&
         std::abs(worstShape(mesh) - std::sqrt(3.0) / 2.0) < 1e-14;
  }
  const auto facets = bisection.meshes()[0].findSide("top")->facets.size();
  return ok && facets == 8 && facets == bisection.meshes()[1].findSide("bottom")->facets.size() ? 0 : 1;
}
