#include "ndframe/assembly/fields.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/assembly/cell_field.hpp"

namespace ndframe
{
namespace
{

template <int dim, int order>
std::vector<std::array<double, 6>> stressAtCentroids(const BodyModel& body, const Vector& displacement)
{
  std::vector<std::array<double, 6>> all(std::size_t(body.mesh.numCells()));
  double centroid[dim + 1];
  std::fill(centroid, centroid + dim + 1, 1.0 / (dim + 1));
  for (int c = 0; c < body.mesh.numCells(); ++c)
    all[std::size_t(c)] = CellField<dim, order>(body, displacement, c).fullStress(centroid);
  return all;
}

template <int dim, int order>
Vector strainEnergies(const BodyModel& body, const Vector& displacement, CellRange cells)
{
  constexpr int strains = dim == 2 ? 3 : 6;
  const QuadratureRule rule = simplexRule(dim, 2 * (order - 1));
  Vector all(std::size_t(cells.size()), 0.0);
  double strain[strains], stress[strains];
  for (int c = cells.first; c < cells.last; ++c) {
    const CellField<dim, order> cell(body, displacement, c);
    for (int g = 0; g < rule.size(); ++g) {
      cell.evaluate(rule.point(g), strain, stress);
      double density = 0.0;
      for (int i = 0; i < strains; ++i)
        density += stress[i] * strain[i];
      all[std::size_t(c - cells.first)] += cell.measure * rule.weights[std::size_t(g)] * density;
    }
  }
  return all;
}

} // namespace

Vector cellEnergies(const BodyModel& body, const Vector& displacement, CellRange cells)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return strainEnergies<d(), p()>(body, displacement, cells); });
}

CellValues cellEnergies(const BodyModel& body, const Vector& displacement)
{
  return ofCells(cellEnergies(body, displacement, {0, body.mesh.numCells()}));
}

std::vector<std::array<double, 6>> cellStress(const BodyModel& body, const Vector& displacement)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return stressAtCentroids<d(), p()>(body, displacement); });
}

CellRange countedCells(const BodyModel& body)
{
  return {0, body.share ? body.share->numOwnCells() : body.mesh.numCells()};
}

CellValues ofCountedCells(const BodyModel& body, CellValues values)
{
  std::fill(values.begin() + countedCells(body).last, values.end(), 0.0);
  return values;
}

double energy(const BodyModel& body, const Vector& displacement, const Comm& comm)
{
  const Vector energies = cellEnergies(body, displacement, countedCells(body));
  Vector sum{std::accumulate(energies.begin(), energies.end(), 0.0)};
  if (body.share)
    comm.sum(sum);
  return sum.front();
}

double energy(const BodyModel& body, const Vector& displacement)
{
  const CellValues energies = cellEnergies(body, displacement);
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

} // namespace ndframe
