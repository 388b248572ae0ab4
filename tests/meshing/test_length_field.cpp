#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "length_field.hpp"
#include "mesh/bisection_scenes.hpp"
#include "meshing/mesh_deck.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

Mesh square(const std::string& more = {})
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "7, 5") +
                  more);
}

/// Triangles of sizes 1 to 1e-4.
Mesh gradedSquare()
{
  const std::vector<Mesh> start{square()};
  Bisection bisection(start, {});
  for (int i = 0; i < 20; ++i)
    bisection.refine(halvingsAt(bisection.meshes(), 1.0, 0.0, 1));
  return bisection.meshes()[0];
}

std::vector<double> atVertices(const Mesh& mesh, double (*function)(double, double))
{
  std::vector<double> values;
  for (int v = 0; v < mesh.numPoints(); ++v)
    values.push_back(function(mesh.point(v)[0], mesh.point(v)[1]));
  return values;
}

double linear(double x, double y)
{
  return 3.0 + 2.0 * x - 0.7 * y;
}

TEST(LengthField, IsLinearWhereItsValuesAre)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (const Mesh& mesh : {square(), square(text("Pattern", "Crossed")), gradedSquare()}) {
    const LengthField field(mesh, atVertices(mesh, linear));
    for (int i = 0; i < 1000; ++i) {
      const double x = std::pow(any(random), i % 10), y = any(random);
      EXPECT_NEAR(field.at({x, y}), linear(x, y), 1e-12);
    }
  }
}

TEST(LengthField, TakesTheValuesOfItsVertices)
{
  const Mesh mesh = gradedSquare();
  std::vector<double> values(std::size_t(mesh.numPoints()));
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = 1.0 + double(v % 17);
  const LengthField field(mesh, values);
  for (int v = 0; v < mesh.numPoints(); ++v)
    EXPECT_NEAR(field.at({mesh.point(v)[0], mesh.point(v)[1]}), values[std::size_t(v)], 1e-9);
}

TEST(LengthField, BeyondTheMeshTheNearestPointCounts)
{
  const Mesh mesh = gradedSquare();
  const LengthField field(mesh, atVertices(mesh, linear));
  EXPECT_NEAR(field.at({0.31, -0.2}), linear(0.31, 0.0), 1e-12);
  EXPECT_NEAR(field.at({1.5, 0.77}), linear(1.0, 0.77), 1e-12);
  EXPECT_NEAR(field.at({-3.0, 4.0}), linear(0.0, 1.0), 1e-12);
}

/// The largest growth of lengths per distance along an edge.
double growth(const Mesh& mesh, const std::vector<double>& lengths)
{
  double largest = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.cell(c)[k], w = mesh.cell(c)[(k + 1) % 3];
      const double distance = std::hypot(mesh.point(v)[0] - mesh.point(w)[0], mesh.point(v)[1] - mesh.point(w)[1]);
      largest = std::max(largest, std::abs(lengths[std::size_t(v)] - lengths[std::size_t(w)]) / distance);
    }
  return largest;
}

TEST(LimitedGrowth, HoldsOnEveryEdgeAndOnlyMakesShorter)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-4.0, 1.0);
  for (const Mesh& mesh : {square(), gradedSquare()}) {
    std::vector<double> lengths;
    for (int v = 0; v < mesh.numPoints(); ++v)
      lengths.push_back(std::pow(10.0, exponent(random)));
    const std::vector<double> limited = withLimitedGrowth(mesh, lengths, 0.5);
    EXPECT_LE(growth(mesh, limited), 0.5 + 1e-9);
    for (std::size_t v = 0; v < lengths.size(); ++v)
      EXPECT_LE(limited[v], lengths[v]);
    EXPECT_EQ(*std::min_element(limited.begin(), limited.end()), *std::min_element(lengths.begin(), lengths.end()));
  }
}

TEST(LimitedGrowth, LeavesSlowGrowthAlone)
{
  const Mesh mesh = gradedSquare();
  const std::vector<double> lengths = atVertices(mesh, [](double x, double y) { return 1.0 + 0.3 * x - 0.2 * y; });
  EXPECT_EQ(withLimitedGrowth(mesh, lengths, 0.5), lengths);
}

} // namespace
