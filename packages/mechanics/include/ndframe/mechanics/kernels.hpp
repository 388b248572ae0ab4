#pragma once

#include <algorithm>
#include <array>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{

/// sigma . grad: the nodal force density of a Voigt stress for the basis gradient g, f = B^T sigma.
template <int dim>
void divergenceForce(const double* g, const double* stress, double* f);

template <>
inline void divergenceForce<2>(const double* g, const double* s, double* f)
{
  f[0] = g[0] * s[0] + g[1] * s[2];
  f[1] = g[1] * s[1] + g[0] * s[2];
}

template <>
inline void divergenceForce<3>(const double* g, const double* s, double* f)
{
  f[0] = g[0] * s[0] + g[1] * s[3] + g[2] * s[5];
  f[1] = g[1] * s[1] + g[0] * s[3] + g[2] * s[4];
  f[2] = g[2] * s[2] + g[1] * s[4] + g[0] * s[5];
}

/// D times the strain of the basis function with gradient g moved along axis `component`.
template <int dim>
void basisStress(const double* g, int component, const Elasticity& law, double* stress)
{
  constexpr int strains = dim == 2 ? 3 : 6;
  double strain[strains] = {};
  if constexpr (dim == 2) {
    strain[component] = g[component];
    strain[2] = g[1 - component];
  } else {
    constexpr int shear[3][3] = {{-1, 3, 5}, {3, -1, 4}, {5, 4, -1}};
    strain[component] = g[component];
    for (int k = 0; k < 3; ++k)
      if (k != component)
        strain[shear[component][k]] = g[k];
  }
  for (int i = 0; i < strains; ++i) {
    stress[i] = 0.0;
    for (int j = 0; j < strains; ++j)
      stress[i] += law(i, j) * strain[j];
  }
}

/// Element stiffness  K_e = int_E B^T D B  of a straight simplex.
///
/// points: (dim + 1) x dim vertex coordinates; law: constant on the element; K: (nodes dim) x (nodes dim), row-major,
/// dof = node * dim + component. Exact (the integrand has degree 2 (order - 1)). Unit: stress * length^(dim - 2).
template <int dim, int order>
void elementStiffness(const double* points, const Elasticity& law, const QuadratureRule& rule, double* K)
{
  constexpr int nodes = Lagrange<dim, order>::nodes, dofs = nodes * dim, strains = dim == 2 ? 3 : 6;
  double gradLambda[(dim + 1) * dim], gradients[nodes * dim], stress[strains], force[dim];
  const double measure = barycentricGradients<dim>(points, gradLambda);
  std::fill_n(K, dofs * dofs, 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    Lagrange<dim, order>::gradients(rule.point(q), gradLambda, gradients);
    const double weight = measure * rule.weights[std::size_t(q)];
    for (int b = 0; b < dofs; ++b) {
      basisStress<dim>(gradients + b / dim * dim, b % dim, law, stress);
      for (int a = 0; a <= b / dim; ++a) {
        divergenceForce<dim>(gradients + a * dim, stress, force);
        for (int k = 0; k < dim; ++k)
          K[(a * dim + k) * dofs + b] += weight * force[k];
      }
    }
  }
  for (int i = 0; i < dofs; ++i)
    for (int j = 0; j < i; ++j)
      K[i * dofs + j] = K[j * dofs + i];
}

/// Voigt stress D eps(u) at the barycentric point lambda, whose gradients are gradLambda ((dim + 1) x dim).
/// u: nodes x dim element displacements.
template <int dim, int order>
void stressAt(const double* gradLambda, const Elasticity& law, const double* lambda, const double* u, double* strain,
              double* stress)
{
  constexpr int nodes = Lagrange<dim, order>::nodes, strains = dim == 2 ? 3 : 6;
  double gradients[nodes * dim];
  Lagrange<dim, order>::gradients(lambda, gradLambda, gradients);
  double grad[dim][dim] = {};
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < dim; ++i)
      for (int k = 0; k < dim; ++k)
        grad[i][k] += u[a * dim + i] * gradients[a * dim + k];
  for (int i = 0; i < dim; ++i)
    strain[i] = grad[i][i];
  strain[dim] = grad[0][1] + grad[1][0];
  if constexpr (dim == 3) {
    strain[4] = grad[1][2] + grad[2][1];
    strain[5] = grad[0][2] + grad[2][0];
  }
  for (int i = 0; i < strains; ++i) {
    stress[i] = 0.0;
    for (int j = 0; j < strains; ++j)
      stress[i] += law(i, j) * strain[j];
  }
}

} // namespace ndframe
