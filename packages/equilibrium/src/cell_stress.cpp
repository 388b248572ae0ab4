#include "ndframe/equilibrium/cell_stress.hpp"

#include <algorithm>

#include "ndframe/assembly/cell_field.hpp"

namespace ndframe
{
namespace
{

template <int dim, int order>
CellStress makeCellStress(const BodyModel& body, int cell, const SortedCell& sorted, const Vector& displacement)
{
  const CellField<dim, order> field(body, displacement, cell);
  CellStress stress;
  stress.dim = dim;
  stress.measure = field.measure;
  double strain[6];
  for (int v = 0; v <= dim; ++v) {
    const int local = sorted.local[std::size_t(v)];
    double lambda[dim + 1] = {};
    lambda[local] = 1.0;
    field.evaluate(lambda, strain, stress.atVertex[v]);
    std::copy_n(field.gradients + local * dim, dim, stress.gradient[v]);
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
  double force[3] = {};
  if (stress.dim == 2)
    divergenceForce<2>(stress.gradient[coordinate], stress.atVertex[vertex], force);
  else
    divergenceForce<3>(stress.gradient[coordinate], stress.atVertex[vertex], force);
  for (int i = 0; i < stress.dim; ++i)
    f[i] += factor * force[i];
}

} // namespace ndframe
