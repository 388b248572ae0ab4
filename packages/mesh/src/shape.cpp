#include "ndframe/mesh/shape.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

double triangleShape(const double* a, const double* b, const double* c)
{
  const double ab[2] = {b[0] - a[0], b[1] - a[1]}, ac[2] = {c[0] - a[0], c[1] - a[1]};
  const double bc[2] = {c[0] - b[0], c[1] - b[1]};
  const double squares = ab[0] * ab[0] + ab[1] * ab[1] + ac[0] * ac[0] + ac[1] * ac[1] + bc[0] * bc[0] + bc[1] * bc[1];
  return 2.0 * std::sqrt(3.0) * (ab[0] * ac[1] - ab[1] * ac[0]) / squares;
}

double worstShape(const Mesh& mesh)
{
  NDFRAME_ASSERT(mesh.dim == 2, "shapes are those of triangles");
  double worst = 1.0;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const int* v = mesh.cell(c);
    worst = std::min(worst, triangleShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])));
  }
  return worst;
}

} // namespace ndframe
