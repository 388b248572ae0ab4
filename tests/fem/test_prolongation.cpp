#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/prolongation.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

/// The field's values at a point of a cell given in barycentric coordinates.
std::vector<double> valueAt(const NodeMap& map, const std::vector<double>& values, int cell, const double* lambda)
{
  std::vector<double> result(std::size_t(map.dim), 0.0);
  withDimAndOrder(map.dim, map.order, [&](auto d, auto p) {
    double N[Lagrange<d(), p()>::nodes];
    Lagrange<d(), p()>::values(lambda, N);
    for (int a = 0; a < map.nodesPerCell; ++a)
      for (int k = 0; k < map.dim; ++k)
        result[std::size_t(k)] += N[a] * values[std::size_t(map.cell(cell)[a] * map.dim + k)];
  });
  return result;
}

/// Random barycentric coordinates in a child, and the same point seen from the parent.
struct Point
{
  double child[4] = {}, parent[4] = {};

  Point(int dim, int number, test::Random& random)
  {
    double sum = 0.0;
    for (int v = 0; v <= dim; ++v)
      sum += child[v] = random(0.0, 1.0);
    for (int v = 0; v <= dim; ++v) {
      child[v] /= sum;
      for (const int corner : childVertices(dim, number)[v])
        parent[corner] += 0.5 * child[v];
    }
  }
};

TEST(Prolongation, IsTheSameField)
{
  test::Random random(3);
  for (const std::vector<int>& cells : {std::vector<int>{3, 2}, std::vector<int>{2, 1, 2}})
    for (const int order : {1, 2}) {
      const Mesh mesh = test::renumbered(test::box(cells, "Alternating", 20.0), 5), refined = refineUniformly(mesh);
      const NodeMap coarse = makeNodeMap(mesh, order), fine = makeNodeMap(refined, order);
      const auto values = random.vector(nodePoints(coarse).size()), result = prolongate(coarse, fine, values);
      for (int c = 0; c < refined.numCells(); ++c) {
        const Point point(mesh.dim, c % numChildren(mesh.dim), random);
        const auto expected = valueAt(coarse, values, c / numChildren(mesh.dim), point.parent);
        const auto found = valueAt(fine, result, c, point.child);
        for (int k = 0; k < mesh.dim; ++k)
          EXPECT_NEAR(found[std::size_t(k)], expected[std::size_t(k)], 1e-14);
      }
    }
}

TEST(Prolongation, RefusesNodesOfAnotherMesh)
{
  const NodeMap coarse = makeNodeMap(test::box({2, 2}), 2);
  EXPECT_THROW(prolongate(coarse, coarse, nodePoints(coarse)), InternalError);
}

} // namespace
} // namespace ndframe
