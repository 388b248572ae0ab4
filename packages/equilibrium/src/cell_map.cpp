#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"
#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

/// The matrix M with (F S F^T)_voigt = M S_voigt, strains x strains.
DenseMatrix pushForward(const CellMap& map)
{
  const int dim = map.dim, strains = numStrains(dim);
  DenseMatrix M(strains, strains);
  for (int s = 0; s < strains; ++s) {
    double unit[6] = {};
    unit[s] = 1.0;
    transformStress(dim, map.F.data(), 1.0, unit, M.col(s));
  }
  return M;
}

} // namespace

CellMap cellMap(const Mesh& mesh, const SortedCell& cell)
{
  const int dim = mesh.dim;
  NDFRAME_ASSERT(dim == 2 || dim == 3, "cells are triangles or tetrahedra");
  CellMap map;
  map.dim = dim;
  double points[12] = {}, gradients[12] = {};
  for (int a = 0; a <= dim; ++a)
    for (int i = 0; i < dim; ++i)
      points[a * dim + i] = mesh.point(cell.vertices[std::size_t(a)])[i];
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k < dim; ++k)
      map.F[std::size_t(i) * std::size_t(dim) + std::size_t(k)] = points[(k + 1) * dim + i] - points[i];
  const double measure =
      dim == 2 ? barycentricGradients<2>(points, gradients) : barycentricGradients<3>(points, gradients);
  map.det = std::abs(measure) / referenceMeasure(dim);
  // The rows of the inverse are the gradients of lambda_1..lambda_dim.
  std::copy(gradients + dim, gradients + std::ptrdiff_t(dim + 1) * dim, map.inverse.begin());
  return map;
}

std::vector<double> pulledBackCompliance(const CellMap& map, const Elasticity& law)
{
  NDFRAME_ASSERT(law.dim == map.dim, "the law is of another dimension");
  const int strains = law.strains();
  const DenseCholesky factor = stiffnessFactor(law);
  const DenseMatrix M = pushForward(map);
  std::vector<double> entries;
  for (int a = 0; a < strains; ++a) {
    const Vector strain = factor.solve(M.column(a));
    for (int b = a; b < strains; ++b)
      entries.push_back(dot(strain, M.column(b)) / map.det);
  }
  return entries;
}

} // namespace ndframe
