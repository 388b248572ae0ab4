#include "oscillation.hpp"

#include <algorithm>
#include <array>
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
  for (int vertex = 0; vertex < mesh.dim; ++vertex)
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

/// K of |grad w|^2 <= K |eps(w)|^2 for w without mean rotation, in the plane.
double kornConstant(const Mesh& mesh, int cell)
{
  const double ratio = roundness(mesh, cell);
  const double inverseBeta2 = 2.0 / (ratio * ratio) * (1.0 + std::sqrt(std::max(0.0, 1.0 - ratio * ratio)));
  return 1.0 + 2.0 * inverseBeta2;
}

/// Squares for Kuhn's tetrahedron, rounded up from 0.6043 and 11.48 (test_oscillation_constants).
constexpr double kuhnCell = 0.61, kuhnFacet = 11.5;

using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// |A|^2, the largest eigenvalue of A^T A, for the matrix of three columns: by the cosines of a third of an angle.
double squaredNorm(const std::array<Vector3, 3>& A)
{
  const double d0 = dot(A[0], A[0]), d1 = dot(A[1], A[1]), d2 = dot(A[2], A[2]);
  const double o01 = dot(A[0], A[1]), o02 = dot(A[0], A[2]), o12 = dot(A[1], A[2]), mean = (d0 + d1 + d2) / 3.0;
  const double a = d0 - mean, b = d1 - mean, c = d2 - mean, off = o01 * o01 + o02 * o02 + o12 * o12;
  const double p = std::sqrt((a * a + b * b + c * c + 2.0 * off) / 6.0);
  if (p == 0.0)
    return mean;
  const double det = a * (b * c - o12 * o12) - o01 * (o01 * c - o12 * o02) + o02 * (o01 * o12 - b * o02);
  return mean + 2.0 * p * std::cos(std::acos(std::clamp(det / (2.0 * p * p * p), -1.0, 1.0)) / 3.0);
}

/// A cell as the image F of Kuhn's tetrahedron for one order of its vertices.
struct KuhnMap
{
  double norm2, inverse2; ///< |F|^2, |F^-1|^2

  KuhnMap(const Mesh& mesh, int cell, const std::array<int, 4>& order)
  {
    std::array<Vector3, 3> F{}; // maps the steps e1, e2, e3 from vertex to vertex
    for (std::size_t step = 0; step < 3; ++step)
      for (std::size_t k = 0; k < 3; ++k)
        F[step][k] = mesh.point(mesh.cell(cell)[order[step + 1]])[k] - mesh.point(mesh.cell(cell)[order[step]])[k];
    const std::array<Vector3, 3> adjugate{cross(F[1], F[2]), cross(F[2], F[0]), cross(F[0], F[1])};
    const double det = dot(F[0], adjugate[0]);
    norm2 = squaredNorm(F);
    inverse2 = squaredNorm(adjugate) / (det * det);
  }
};

/// The least value over all orders of the vertices; an order and its reverse are alike.
template <class Value>
double best(const Mesh& mesh, int cell, const Value& value)
{
  std::array<int, 4> order{0, 1, 2, 3};
  double least = HUGE_VAL;
  do
    if (order.front() < order.back())
      least = std::min(least, value(KuhnMap(mesh, cell, order), order));
  while (std::next_permutation(order.begin(), order.end()));
  return least;
}

double cellConstantInSpace(const Mesh& mesh, int cell)
{
  return std::sqrt(best(mesh, cell, [](const KuhnMap& map, const std::array<int, 4>&) {
    return map.norm2 * map.norm2 * map.inverse2 * kuhnCell;
  }));
}

double facetConstantInSpace(const Mesh& mesh, Facet facet)
{
  double normal[3];
  const double area = facetNormal(mesh, facet, normal), det = 6.0 * cellMeasure(mesh, facet.cell);
  return std::sqrt(best(mesh, facet.cell, [&](const KuhnMap& map, const std::array<int, 4>& order) {
    const bool isOuter = order.front() == facet.local || order.back() == facet.local; // of area 1/2, others 1/sqrt(2)
    return map.norm2 * map.norm2 * map.inverse2 * area / (isOuter ? 0.5 : std::sqrt(0.5)) / det * kuhnFacet;
  }));
}

} // namespace

double cellOscillationConstant(const Mesh& mesh, int cell)
{
  if (mesh.dim == 3)
    return cellConstantInSpace(mesh, cell);
  return cellDiameter(mesh, cell) / M_PI * std::sqrt(kornConstant(mesh, cell));
}

double facetOscillationConstant(const Mesh& mesh, Facet facet)
{
  if (mesh.dim == 3)
    return facetConstantInSpace(mesh, facet);
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
