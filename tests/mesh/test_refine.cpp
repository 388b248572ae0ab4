#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/refine.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

/// Boxes of both dimensions in every pattern, sheared so that no cell is like another by chance.
std::vector<Mesh> samples()
{
  std::vector<Mesh> meshes;
  const auto add = [&](const char* corner, const char* cells, const char* pattern) {
    const std::string origin = std::string(corner).size() > 4 ? "0, 0, 0" : "0, 0";
    meshes.push_back(readMesh(text("Type", "Box") + doubles("Lower", origin) + doubles("Upper", corner) +
                              ints("Cells", cells) + text("Pattern", pattern)));
    Mesh& mesh = meshes.back();
    for (int p = 0; p < mesh.numPoints(); ++p) {
      double* x = mesh.points.data() + p * mesh.dim;
      x[0] += 0.3 * x[1] - 0.1 * x[0] * x[0];
    }
  };
  for (const char* pattern : {"Right", "Alternating", "Crossed"})
    add("3, 1", "3, 2", pattern);
  for (const char* pattern : {"Right", "Alternating"})
    add("2, 1, 1", "2, 2, 2", pattern);
  return meshes;
}

/// The squared edge lengths in ascending order over the volume^(2/3): equal for similar tetrahedra.
std::vector<double> shape(const Mesh& mesh, int cell)
{
  std::vector<double> squares;
  const double unit = std::pow(cellMeasure(mesh, cell), 2.0 / 3.0);
  for (int b = 1; b <= 3; ++b)
    for (int a = 0; a < b; ++a) {
      double square = 0.0;
      for (int k = 0; k < 3; ++k)
        square += std::pow(mesh.point(mesh.cell(cell)[a])[k] - mesh.point(mesh.cell(cell)[b])[k], 2);
      squares.push_back(std::round(1e8 * square / unit));
    }
  std::sort(squares.begin(), squares.end());
  return squares;
}

std::vector<double> centre(const Mesh& mesh, Facet facet)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  std::vector<double> x(3, 0.0);
  for (int v = 0; v < mesh.dim; ++v)
    for (int k = 0; k < mesh.dim; ++k)
      x[std::size_t(k)] += mesh.point(vertices[v])[k] / mesh.dim;
  return x;
}

TEST(Refine, KeepsTheBodyAndStaysSound)
{
  for (const Mesh& mesh : samples()) {
    const Mesh fine = refineUniformly(mesh);
    EXPECT_EQ(checkMesh(fine), std::vector<std::string>{});
    EXPECT_NEAR(volume(fine), volume(mesh), 1e-13 * volume(mesh));
    EXPECT_EQ(fine.numCells(), mesh.numCells() << mesh.dim);
    EXPECT_TRUE(std::equal(mesh.points.begin(), mesh.points.end(), fine.points.begin()));
  }
}

TEST(Refine, ChildrenShareTheirParentEqually)
{
  for (const Mesh& mesh : samples()) {
    const Mesh fine = refineUniformly(mesh);
    for (int c = 0; c < fine.numCells(); ++c)
      EXPECT_NEAR(cellMeasure(fine, c) * numChildren(mesh.dim) / cellMeasure(mesh, c / numChildren(mesh.dim)), 1.0,
                  1e-12);
  }
}

TEST(Refine, ChildrenAreInTheGroupsOfTheirParent)
{
  for (Mesh mesh : samples()) {
    EXPECT_TRUE(refineUniformly(mesh).groups.kind.empty());
    for (int c = 0; c < mesh.numCells(); ++c)
      mesh.groups.kind.push_back(
          mesh.groups.findOrAdd(c % 3 == 0 ? std::vector<std::string>{} : std::vector<std::string>{"some", "more"}));
    const Mesh fine = refineUniformly(mesh);
    EXPECT_EQ(fine.groups.names, (std::vector<std::vector<std::string>>{{}, {"more", "some"}}));
    for (int c = 0; c < fine.numCells(); ++c)
      EXPECT_EQ(fine.groups.kind[std::size_t(c)], c / numChildren(mesh.dim) % 3 == 0 ? 0 : 1);
  }
}

TEST(Refine, ChildVerticesAreWhereTheTableSays)
{
  for (const Mesh& mesh : samples()) {
    const Mesh fine = refineUniformly(mesh);
    for (int c = 0; c < fine.numCells(); ++c)
      for (int v = 0; v <= mesh.dim; ++v) {
        const int* parent = mesh.cell(c / numChildren(mesh.dim));
        const auto [a, b] = childVertices(mesh.dim, c % numChildren(mesh.dim))[v];
        for (int k = 0; k < mesh.dim; ++k)
          EXPECT_DOUBLE_EQ(fine.point(fine.cell(c)[v])[k], 0.5 * (mesh.point(parent[a])[k] + mesh.point(parent[b])[k]));
      }
  }
}

TEST(Refine, SideFacetsLieOnTheirParents)
{
  for (const Mesh& mesh : samples()) {
    const Mesh fine = refineUniformly(mesh);
    ASSERT_EQ(fine.sides.size(), mesh.sides.size());
    const std::size_t children = std::size_t(numChildren(mesh.dim)) / 2;
    for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
      EXPECT_EQ(fine.sides[s].name, mesh.sides[s].name);
      ASSERT_EQ(fine.sides[s].facets.size(), children * mesh.sides[s].facets.size());
      for (std::size_t f = 0; f < mesh.sides[s].facets.size(); ++f) {
        double normal[3], childNormal[3], total = 0.0;
        const double size = facetNormal(mesh, mesh.sides[s].facets[f], normal);
        const auto middle = centre(mesh, mesh.sides[s].facets[f]);
        for (std::size_t k = 0; k < children; ++k) {
          const Facet child = fine.sides[s].facets[f * children + k];
          total += facetNormal(fine, child, childNormal);
          double off = 0.0;
          for (int i = 0; i < mesh.dim; ++i) {
            EXPECT_NEAR(childNormal[i], normal[i], 1e-12);
            off += normal[i] * (centre(fine, child)[std::size_t(i)] - middle[std::size_t(i)]);
          }
          EXPECT_NEAR(off, 0.0, 1e-13);
        }
        EXPECT_NEAR(total, size, 1e-13);
      }
    }
  }
}

TEST(Refine, DescendantsOfATetrahedronHaveThreeShapes)
{
  Mesh mesh{3, {0, 0, 0, 1.1, 0.2, 0.1, 0.3, 0.9, -0.2, 0.2, 0.4, 1.3}, {0, 1, 2, 3}, {}, {}};
  for (int level = 0; level < 4; ++level)
    mesh = refineUniformly(mesh);
  std::set<std::vector<double>> shapes;
  for (int c = 0; c < mesh.numCells(); ++c)
    shapes.insert(shape(mesh, c));
  EXPECT_EQ(shapes.size(), 3U);
}

} // namespace
