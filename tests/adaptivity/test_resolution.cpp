// Cells that should become ever smaller towards a corner end where their coordinates cannot tell them apart any more.

#include <cmath>

#include <gtest/gtest.h>

#include "components.hpp"
#include "ndframe/adaptivity/size_field.hpp"

using namespace ndframe;

namespace
{

/// The simplex with edges of length 1 along the axes from (1, 1, ..).
Mesh simplexAtOne(int dim)
{
  Mesh mesh;
  mesh.dim = dim;
  for (int v = 0; v <= dim; ++v) {
    for (int k = 0; k < dim; ++k)
      mesh.points.push_back(v == k + 1 ? 2.0 : 1.0);
    mesh.cells.push_back(v);
  }
  return mesh;
}

/// Cells a good deal smaller than their distance from (1, 1, ..), whatever that is.
SizeField towardsCorner(const RefinedMeshes& meshes)
{
  SizeField sizes;
  for (const Mesh& mesh : meshes.meshes()) {
    CellSize size{-4.5, 0.5 * mesh.dim, -1e4, {}};
    for (int k = 0; k < mesh.dim; ++k)
      size.place.point[std::size_t(k)] = 1.0;
    sizes.emplace_back(std::size_t(mesh.numCells()), size);
  }
  return sizes;
}

double shortestEdge(const Mesh& mesh)
{
  double shortest = 1.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int a = 0; a <= mesh.dim; ++a)
      for (int b = 0; b < a; ++b) {
        double square = 0.0;
        for (int k = 0; k < mesh.dim; ++k)
          square += std::pow(mesh.point(mesh.cell(c)[a])[k] - mesh.point(mesh.cell(c)[b])[k], 2);
        shortest = std::min(shortest, std::sqrt(square));
      }
  return shortest;
}

} // namespace

TEST(BisectionTowardsACorner, EndsWhereCoordinatesEnd)
{
  for (const int dim : {2, 3}) {
    auto meshes = test::bisected(simplexAtOne(dim));
    meshes = meshes->refined(towardsCorner(*meshes));
    EXPECT_FALSE(meshes->areUnchanged());
    EXPECT_LT(shortestEdge(meshes->meshes().front()), 0x1p-38) << dim;
    EXPECT_GT(shortestEdge(meshes->meshes().front()), 0x1p-45) << dim;
    for (int c = 0; c < meshes->meshes().front().numCells(); ++c)
      EXPECT_GT(cellMeasure(meshes->meshes().front(), c), 0.0);
    const auto next = meshes->refined(towardsCorner(*meshes));
    EXPECT_TRUE(next->areUnchanged()) << dim;
  }
}
