#include "oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{
namespace
{

double distance(const double* a, const double* b, int dim)
{
  double square = 0.0;
  for (int k = 0; k < dim; ++k)
    square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}

double longestEdge(const Mesh& mesh, int cell, int vertex)
{
  const int* vertices = mesh.cell(cell);
  double longest = 0.0;
  for (int other = 0; other <= mesh.dim; ++other)
    longest = std::max(longest, distance(mesh.point(vertices[vertex]), mesh.point(vertices[other]), mesh.dim));
  return longest;
}

double cellDiameter(const Mesh& mesh, int cell)
{
  double longest = 0.0;
  for (int vertex = 0; vertex <= mesh.dim; ++vertex)
    longest = std::max(longest, longestEdge(mesh, cell, vertex));
  return longest;
}

/// rho / R: the inradius over the distance of the incentre from the farthest vertex.
double roundness(const Mesh& mesh, int cell)
{
  const int* vertices = mesh.cell(cell);
  double surface = 0.0, incentre[3] = {}, normal[3], farthest = 0.0;
  for (int v = 0; v <= mesh.dim; ++v) {
    const double facet = facetNormal(mesh, {cell, v}, normal);
    surface += facet;
    for (int k = 0; k < mesh.dim; ++k)
      incentre[k] += facet * mesh.point(vertices[v])[k];
  }
  for (int k = 0; k < mesh.dim; ++k)
    incentre[k] /= surface;
  for (int v = 0; v <= mesh.dim; ++v)
    farthest = std::max(farthest, distance(incentre, mesh.point(vertices[v]), mesh.dim));
  return mesh.dim * cellMeasure(mesh, cell) / surface / farthest;
}

/// K of |grad w|^2 <= K |eps(w)|^2 for w without mean rotation.
double kornConstant(const Mesh& mesh, int cell)
{
  const double ratio = roundness(mesh, cell);
  const double inverseBeta2 = 2.0 / (ratio * ratio) * (1.0 + std::sqrt(std::max(0.0, 1.0 - ratio * ratio)));
  return mesh.dim == 2 ? 1.0 + 2.0 * inverseBeta2 : 2.0 * (1.0 + 4.0 * inverseBeta2);
}

} // namespace

double cellOscillationConstant(const Mesh& mesh, int cell)
{
  return cellDiameter(mesh, cell) / M_PI * std::sqrt(kornConstant(mesh, cell));
}

double facetOscillationConstant(const Mesh& mesh, Facet facet)
{
  double normal[3];
  const double poincare = cellDiameter(mesh, facet.cell) / M_PI, height = longestEdge(mesh, facet.cell, facet.local);
  const double ratio = facetNormal(mesh, facet, normal) / cellMeasure(mesh, facet.cell);
  return std::sqrt(ratio * (poincare * poincare + 2.0 * height / mesh.dim * poincare) * kornConstant(mesh, facet.cell));
}

double smallestStiffness(const Elasticity& law)
{
  const int n = law.strains();
  const auto mandel = [&law](int i) { return i < law.dim ? 1.0 : std::sqrt(2.0); };
  DenseMatrix D(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      D(i, j) = mandel(i) * law(i, j) * mandel(j);
  double low = 0.0, high = D(0, 0);
  for (int i = 1; i < n; ++i)
    high = std::min(high, D(i, i));
  for (int step = 0; step < 60; ++step) { // bisection: D - s is positive definite below the smallest eigenvalue
    const double middle = 0.5 * (low + high);
    DenseMatrix shifted = D;
    for (int i = 0; i < n; ++i)
      shifted(i, i) -= middle;
    try {
      [[maybe_unused]] const DenseCholesky exists(std::move(shifted));
      low = middle;
    } catch (const NotPositiveDefinite&) {
      high = middle;
    }
  }
  return low;
}

Vector smallestStiffness(const CellLaws& laws)
{
  Vector ofLaws;
  for (const Elasticity& law : laws.all())
    ofLaws.push_back(smallestStiffness(law));
  return ofLaws;
}

} // namespace ndframe
