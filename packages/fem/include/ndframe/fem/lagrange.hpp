#pragma once

#include <array>

namespace ndframe
{

/// Edges of the reference simplex by their local vertices, in the order in which order-2 nodes follow the vertices.
template <int dim>
struct SimplexEdges;

/// The edge itself.
template <>
struct SimplexEdges<1>
{
  /// Local vertices at its ends.
  static constexpr std::array<std::array<int, 2>, 1> vertices{{{0, 1}}};
};

/// Those of a triangle, once around.
template <>
struct SimplexEdges<2>
{
  /// Local vertices at the ends of each.
  static constexpr std::array<std::array<int, 2>, 3> vertices{{{0, 1}, {1, 2}, {2, 0}}};
};

/// Those of a tetrahedron: around the triangle 012, then those to vertex 3.
template <>
struct SimplexEdges<3>
{
  /// Local vertices at the ends of each.
  static constexpr std::array<std::array<int, 2>, 6> vertices{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
};

/// Lagrange basis of order 1 or 2 on the simplex of dimension dim, in barycentric coordinates lambda_0..lambda_dim.
///
///   order 1: N_a = lambda_a;   order 2: N_a = lambda_a (2 lambda_a - 1), N_ab = 4 lambda_a lambda_b on edge ab.
template <int dim, int order>
struct Lagrange
{
  static_assert(order == 1 || order == 2);
  static constexpr int vertices = dim + 1;                               ///< of the simplex
  static constexpr int edges = int(SimplexEdges<dim>::vertices.size());  ///< of the simplex
  static constexpr int nodes = order == 1 ? vertices : vertices + edges; ///< basis functions

  /// Values of all basis functions at the point with barycentric coordinates lambda (dim + 1 values).
  static void values(const double* lambda, double* N)
  {
    for (int a = 0; a < vertices; ++a)
      N[a] = order == 1 ? lambda[a] : lambda[a] * (2.0 * lambda[a] - 1.0);
    if constexpr (order == 2)
      for (int e = 0; e < edges; ++e)
        N[vertices + e] = 4.0 * lambda[SimplexEdges<dim>::vertices[e][0]] * lambda[SimplexEdges<dim>::vertices[e][1]];
  }

  /// Gradients of all basis functions; gradLambda: (dim + 1) x dim gradients of the barycentric coordinates;
  /// dN: nodes x dim, row-major.
  static void gradients(const double* lambda, const double* gradLambda, double* dN)
  {
    for (int a = 0; a < vertices; ++a)
      for (int k = 0; k < dim; ++k)
        dN[a * dim + k] = (order == 1 ? 1.0 : 4.0 * lambda[a] - 1.0) * gradLambda[a * dim + k];
    if constexpr (order == 2)
      for (int e = 0; e < edges; ++e) {
        const int a = SimplexEdges<dim>::vertices[e][0], b = SimplexEdges<dim>::vertices[e][1];
        for (int k = 0; k < dim; ++k)
          dN[(vertices + e) * dim + k] =
              4.0 * (lambda[a] * gradLambda[b * dim + k] + lambda[b] * gradLambda[a * dim + k]);
      }
  }
};

/// Gradients of the barycentric coordinates of a straight simplex ((dim + 1) x dim); returns its signed measure.
template <int dim>
double barycentricGradients(const double* points, double* gradLambda);

/// Calls `run(std::integral_constant<int, dim>, std::integral_constant<int, order>)` for the pair given at run time:
/// the one switch between dimension and order as data and as template parameters.
template <class Run>
decltype(auto) withDimAndOrder(int dim, int order, Run&& run);

} // namespace ndframe

#include "ndframe/fem/lagrange_impl.hpp"
