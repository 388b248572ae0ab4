#include "ndframe/assembly/fields.hpp"

#include <algorithm>

#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

template <int dim, int order>
std::vector<std::array<double, 6>> stressAtCentroids(const BodyModel& body, const Vector& displacement)
{
  constexpr int nodesPerCell = Lagrange<dim, order>::nodes, strains = dim == 2 ? 3 : 6;
  std::vector<std::array<double, 6>> all(std::size_t(body.mesh.numCells()));
  double centroid[dim + 1], points[(dim + 1) * dim], u[nodesPerCell * dim], strain[strains], stress[strains];
  std::fill(centroid, centroid + dim + 1, 1.0 / (dim + 1));
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    for (int v = 0; v <= dim; ++v)
      std::copy_n(body.mesh.point(body.mesh.cell(c)[v]), dim, points + v * dim);
    for (int a = 0; a < nodesPerCell; ++a)
      std::copy_n(displacement.data() + std::size_t(body.nodes.cell(c)[a] * dim), dim, u + a * dim);
    stressAt<dim, order>(points, body.law, centroid, u, strain, stress);
    if constexpr (dim == 3)
      std::copy_n(stress, 6, all[std::size_t(c)].begin());
    else {
      double outOfPlane = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
        outOfPlane += body.law.outOfPlane[i] * strain[i];
      all[std::size_t(c)] = {stress[0], stress[1], outOfPlane, stress[2], 0.0, 0.0};
    }
  }
  return all;
}

} // namespace

std::vector<std::array<double, 6>> cellStress(const BodyModel& body, const Vector& displacement)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return stressAtCentroids<d(), p()>(body, displacement); });
}

double energy(const BodySystem& system, const Vector& u, const Comm& comm)
{
  return dot(u, multiply(system.K, u, comm));
}

} // namespace ndframe
