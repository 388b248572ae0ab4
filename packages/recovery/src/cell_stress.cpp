#include "cell_stress.hpp"

#include <algorithm>

#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

template <int dim, int order>
CellStress makeCellStress(const BodyModel& body, int cell, const SortedCell& sorted, const Vector& displacement)
{
  constexpr int nodes = Lagrange<dim, order>::nodes;
  CellStress stress;
  stress.dim = dim;
  double points[(dim + 1) * dim], gradients[(dim + 1) * dim], u[nodes * dim], strain[6];
  for (int v = 0; v <= dim; ++v)
    std::copy_n(body.mesh.point(body.mesh.cell(cell)[v]), dim, points + v * dim);
  for (int a = 0; a < nodes; ++a)
    std::copy_n(displacement.data() + std::size_t(body.nodes.cell(cell)[a] * dim), dim, u + a * dim);
  stress.measure = barycentricGradients<dim>(points, gradients);
  for (int v = 0; v <= dim; ++v) {
    const int local = sorted.local[std::size_t(v)];
    double lambda[dim + 1] = {};
    lambda[local] = 1.0;
    stressAt<dim, order>(points, body.law, lambda, u, strain, stress.atVertex[v]);
    std::copy_n(gradients + local * dim, dim, stress.gradient[v]);
  }
  return stress;
}

} // namespace

CellStress cellStress(const BodyModel& body, int cell, const SortedCell& sorted, const Vector& displacement)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return makeCellStress<d(), p()>(body, cell, sorted, displacement); });
}

void addForce(const CellStress& stress, int vertex, int coordinate, double factor, double* f)
{
  double force[3];
  if (stress.dim == 2)
    divergenceForce<2>(stress.gradient[coordinate], stress.atVertex[vertex], force);
  else
    divergenceForce<3>(stress.gradient[coordinate], stress.atVertex[vertex], force);
  for (int i = 0; i < stress.dim; ++i)
    f[i] += factor * force[i];
}

} // namespace ndframe
