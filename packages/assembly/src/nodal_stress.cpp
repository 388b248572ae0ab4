#include "ndframe/assembly/nodal_stress.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/cell_field.hpp"

namespace ndframe
{
namespace
{

/// A vertex counts when its strain is larger by more than round-off: else the one before it does.
constexpr double equallyLarge = 1e-9;
constexpr double pi = 3.14159265358979323846;

/// Barycentric coordinates of a cell's nodes, in their local order: nodes x (dim + 1).
template <int dim, int order>
void nodeCoordinates(double* lambda)
{
  using Basis = Lagrange<dim, order>;
  std::fill_n(lambda, Basis::nodes * (dim + 1), 0.0);
  for (int v = 0; v <= dim; ++v)
    lambda[v * (dim + 1) + v] = 1.0;
  if constexpr (order == 2)
    for (int e = 0; e < Basis::edges; ++e)
      for (const int end : SimplexEdges<dim>::vertices[e])
        lambda[(Basis::vertices + e) * (dim + 1) + end] = 0.5;
}

template <int dim, int order>
std::vector<std::array<double, 6>> averageAtNodes(const BodyModel& body, const Vector& displacement)
{
  constexpr int nodes = Lagrange<dim, order>::nodes;
  double lambda[nodes * (dim + 1)];
  nodeCoordinates<dim, order>(lambda);
  std::vector<std::array<double, 6>> sum(std::size_t(body.nodes.numNodes()));
  Vector weight(sum.size(), 0.0);
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    const CellField<dim, order> cell(body, displacement, c);
    const double measure = cellMeasure(body.mesh, c);
    for (int a = 0; a < nodes; ++a) {
      const auto value = cell.fullStress(lambda + a * (dim + 1));
      const auto node = std::size_t(body.nodes.cell(c)[a]);
      weight[node] += measure;
      for (std::size_t i = 0; i < value.size(); ++i)
        sum[node][i] += measure * value[i];
    }
  }
  for (std::size_t node = 0; node < sum.size(); ++node)
    for (double& component : sum[node])
      component /= weight[node];
  return sum;
}

/// The largest absolute eigenvalue of a symmetric matrix in Voigt notation with engineering shears.
template <int dim>
double largestPrincipal(const double* e)
{
  if constexpr (dim == 2)
    return 0.5 * (std::abs(e[0] + e[1]) + std::hypot(e[0] - e[1], e[2]));
  const double mean = (e[0] + e[1] + e[2]) / 3.0, x = e[0] - mean, y = e[1] - mean, z = e[2] - mean;
  const double xy = 0.5 * e[3], yz = 0.5 * e[4], xz = 0.5 * e[5];
  const double radius = std::sqrt((x * x + y * y + z * z + 2.0 * (xy * xy + yz * yz + xz * xz)) / 6.0);
  if (radius == 0.0)
    return std::abs(mean);
  const double r3 = radius * radius * radius;
  const double half = 0.5 * (x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz)) / r3;
  const double angle = std::acos(std::clamp(half, -1.0, 1.0)) / 3.0;
  return std::max(std::abs(mean + 2.0 * radius * std::cos(angle)),
                  std::abs(mean + 2.0 * radius * std::cos(angle + 2.0 * pi / 3.0)));
}

template <int dim, int order>
std::vector<CellStrain> strainsAtVertices(const BodyModel& body, const Vector& displacement, CellRange cells)
{
  constexpr int strains = dim == 2 ? 3 : 6;
  std::vector<CellStrain> all(std::size_t(cells.size()));
  double strain[strains], stress[strains];
  for (int c = cells.first; c < cells.last; ++c) {
    const CellField<dim, order> cell(body, displacement, c);
    CellStrain& largest = all[std::size_t(c - cells.first)];
    largest = {-1.0, 0};
    for (int v = 0; v <= dim; ++v) {
      double lambda[dim + 1] = {};
      lambda[v] = 1.0;
      cell.evaluate(lambda, strain, stress);
      if (const double value = largestPrincipal<dim>(strain); !(value <= (1.0 + equallyLarge) * largest.value))
        largest = {value, body.mesh.cell(c)[v]};
    }
  }
  return all;
}

} // namespace

std::vector<std::array<double, 6>> nodalStress(const BodyModel& body, const Vector& displacement)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return averageAtNodes<d(), p()>(body, displacement); });
}

std::vector<CellStrain> largestStrains(const BodyModel& body, const Vector& displacement, CellRange cells)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return strainsAtVertices<d(), p()>(body, displacement, cells); });
}

} // namespace ndframe
