#include "ndframe/mesh/shape.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

double triangleShape(const double* a, const double* b, const double* c)
{
  const double ab[2] = {b[0] - a[0], b[1] - a[1]}, ac[2] = {c[0] - a[0], c[1] - a[1]};
  const double bc[2] = {c[0] - b[0], c[1] - b[1]};
  const double squares = ab[0] * ab[0] + ab[1] * ab[1] + ac[0] * ac[0] + ac[1] * ac[1] + bc[0] * bc[0] + bc[1] * bc[1];
  return 2.0 * std::sqrt(3.0) * (ab[0] * ac[1] - ab[1] * ac[0]) / squares;
}

double tetrahedronShape(const double* a, const double* b, const double* c, const double* d)
{
  const double* const points[4] = {a, b, c, d};
  double edges[3][3], squares = 0.0; // from a
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < 3; ++k) {
        const double difference = points[i][k] - points[j][k];
        squares += difference * difference;
        if (j == 0)
          edges[i - 1][k] = difference;
      }
  const double *u = edges[0], *v = edges[1], *w = edges[2];
  const double tripled = 0.5 * (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                u[2] * (v[0] * w[1] - v[1] * w[0])); // of the volume
  return 12.0 * std::copysign(std::cbrt(tripled * tripled), tripled) / squares;
}

double worstShape(const Mesh& mesh)
{
  double worst = 1.0;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const int* v = mesh.cell(c);
    worst = std::min(worst, mesh.dim == 2 ? triangleShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]))
                                          : tetrahedronShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]),
                                                             mesh.point(v[3])));
  }
  return worst;
}

} // namespace ndframe
