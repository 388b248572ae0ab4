#pragma once

#include <type_traits>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

template <>
inline double barycentricGradients<2>(const double* p, double* g)
{
  const double ax = p[2] - p[0], ay = p[3] - p[1], bx = p[4] - p[0], by = p[5] - p[1];
  const double det = ax * by - ay * bx;
  g[2] = by / det, g[3] = -bx / det;
  g[4] = -ay / det, g[5] = ax / det;
  g[0] = -g[2] - g[4], g[1] = -g[3] - g[5];
  return 0.5 * det;
}

template <>
inline double barycentricGradients<3>(const double* p, double* g)
{
  const double a[3] = {p[3] - p[0], p[4] - p[1], p[5] - p[2]};
  const double b[3] = {p[6] - p[0], p[7] - p[1], p[8] - p[2]};
  const double c[3] = {p[9] - p[0], p[10] - p[1], p[11] - p[2]};
  const auto cross = [](const double* u, const double* v, double* w) {
    w[0] = u[1] * v[2] - u[2] * v[1];
    w[1] = u[2] * v[0] - u[0] * v[2];
    w[2] = u[0] * v[1] - u[1] * v[0];
  };
  cross(b, c, g + 3);
  cross(c, a, g + 6);
  cross(a, b, g + 9);
  const double det = a[0] * g[3] + a[1] * g[4] + a[2] * g[5];
  for (int k = 3; k < 12; ++k)
    g[k] /= det;
  for (int k = 0; k < 3; ++k)
    g[k] = -g[3 + k] - g[6 + k] - g[9 + k];
  return det / 6.0;
}

template <class Run>
decltype(auto) withDimAndOrder(int dim, int order, Run&& run)
{
  NDFRAME_ASSERT((dim == 2 || dim == 3) && (order == 1 || order == 2), "kernels exist for dim 2, 3 and order 1, 2");
  using std::integral_constant;
  if (dim == 2)
    return order == 1 ? run(integral_constant<int, 2>{}, integral_constant<int, 1>{})
                      : run(integral_constant<int, 2>{}, integral_constant<int, 2>{});
  return order == 1 ? run(integral_constant<int, 3>{}, integral_constant<int, 1>{})
                    : run(integral_constant<int, 3>{}, integral_constant<int, 2>{});
}

} // namespace ndframe
