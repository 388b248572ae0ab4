#include "oscillation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/fem/lagrange.hpp"

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

/// Squares for Kuhn's tetrahedron, rounded up from 0.6043, 11.48 and, for what is orthogonal to quadratic tractions,
/// 5.989 (test_oscillation_constants).
constexpr double kuhnCell = 0.61, kuhnFacet = 11.5, kuhnFacetBeyond2 = 6.0;

/// |A|^2, the largest eigenvalue of A A^T, for the matrix of three rows: by the cosine of a third of an angle.
double squaredNorm(const std::array<Direction, 3>& A)
{
  const double d0 = dotProduct(A[0], A[0]), d1 = dotProduct(A[1], A[1]), d2 = dotProduct(A[2], A[2]);
  const double o01 = dotProduct(A[0], A[1]), o02 = dotProduct(A[0], A[2]), o12 = dotProduct(A[1], A[2]);
  const double mean = (d0 + d1 + d2) / 3.0;
  const double p = std::sqrt((std::pow(d0 - mean, 2) + std::pow(d1 - mean, 2) + std::pow(d2 - mean, 2) +
                              2.0 * (o01 * o01 + o02 * o02 + o12 * o12)) /
                             6.0);
  if (!(p > 0.0))
    return mean;
  const double a = (d0 - mean) / p, b = (d1 - mean) / p, c = (d2 - mean) / p, x = o01 / p, y = o02 / p, z = o12 / p;
  const double det = a * (b * c - z * z) - x * (x * c - z * y) + y * (x * z - b * y);
  return mean + 2.0 * p * std::cos(std::acos(std::clamp(0.5 * det, -1.0, 1.0)) / 3.0);
}

/// A cell as the image F of Kuhn's tetrahedron for one order of its vertices.
struct KuhnMap
{
  double norm2, inverse2; ///< |F|^2, |F^-1|^2

  /// points: of its vertices; gradients: of its barycentric coordinates.
  KuhnMap(const double* points, const double* gradients, const std::array<int, 4>& order)
  {
    std::array<Direction, 3> F{}, inverse{}; // the steps from vertex to vertex; gradients of their coordinates
    for (std::size_t step = 3; step-- > 0;)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = 3 * std::size_t(order[step]) + k, to = 3 * std::size_t(order[step + 1]) + k;
        F[step][k] = points[to] - points[from];
        inverse[step][k] = gradients[to] + (step < 2 ? inverse[step + 1][k] : 0.0);
      }
    norm2 = squaredNorm(F);
    inverse2 = squaredNorm(inverse);
  }
};

/// The least value over all orders of the vertices; an order and its reverse are alike.
template <class Value>
double best(const Mesh& mesh, int cell, const Value& value)
{
  double points[12], gradients[12], least = HUGE_VAL;
  cellPoints(mesh, cell, points);
  barycentricGradients<3>(points, gradients);
  std::array<int, 4> order{0, 1, 2, 3};
  do
    if (order.front() < order.back())
      least = std::min(least, value(KuhnMap(points, gradients, order), order));
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

double shareBeyondPolynomials(int dim, int degree)
{
  return dim == 3 && degree >= 2 ? std::sqrt(kuhnFacetBeyond2 / kuhnFacet) : 1.0;
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
