#include "ndframe/adaptivity/corner_exponents.hpp"

#include <cmath>

#include <gtest/gtest.h>

using namespace ndframe;

namespace
{

constexpr int degree = 2;

/// A fan of four triangles of this size around the origin, vertex 0.
Mesh fan(double size)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, size, 0, 0, size, -size, 0, 0, -size};
  mesh.cells = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  return mesh;
}

/// eta_K of the fan if the solution is like r^lambda: sum eta_K^2 = A^lambda.
Vector contributionsOf(double size, double lambda)
{
  return Vector(4, std::sqrt(std::pow(2.0 * size * size, lambda) / 4.0));
}

double learned(double lambda, double before, double after)
{
  CornerExponents exponents(degree);
  const Mesh coarse = fan(before), fine = fan(after);
  exponents.observe({&coarse}, {contributionsOf(before, lambda)});
  exponents.observe({&fine}, {contributionsOf(after, lambda)});
  return exponents.exponents()[0][0];
}

} // namespace

TEST(CornerExponents, AreFoundFromTwoMeshes)
{
  for (const double lambda : {0.774, 1.0, 1.5, 2.7})
    for (const double after : {0.7, 0.5, 0.01})
      EXPECT_NEAR(learned(lambda, 1.0, after), lambda, 1e-12);
}

TEST(CornerExponents, AreThoseOfASmoothSolutionUntilSomethingIsLearned)
{
  CornerExponents exponents(degree);
  const Mesh mesh = fan(1.0);
  exponents.observe({&mesh}, {contributionsOf(1.0, 0.5)});
  EXPECT_EQ(exponents.exponents()[0], Vector(5, degree + 1.0));
  exponents.observe({&mesh}, {contributionsOf(1.0, 0.5)}); // not refined
  EXPECT_EQ(exponents.exponents()[0], Vector(5, degree + 1.0));
}

TEST(CornerExponents, AreNotLearnedAtVerticesMadeLater)
{
  CornerExponents exponents(degree);
  const Mesh first = fan(4.0);
  std::vector<Mesh> later{fan(1.0), fan(0.5)};
  for (Mesh& mesh : later) { // the fan's middle is now vertex 5
    mesh.points.insert(mesh.points.end(), {0.0, 0.0});
    for (int& vertex : mesh.cells)
      vertex = vertex == 0 ? 5 : vertex;
    mesh.cells.insert(mesh.cells.end(), mesh.cells.begin(), mesh.cells.begin() + 3);
  }
  exponents.observe({&first}, {contributionsOf(4.0, 0.8)});
  for (const Mesh& mesh : later)
    exponents.observe({&mesh}, {Vector(5, std::sqrt(std::pow(cellMeasure(mesh, 0), 0.8)))});
  EXPECT_EQ(exponents.exponents()[0][5], degree + 1.0);
  EXPECT_EQ(exponents.exponents()[0][1], degree + 1.0) << "not where vertex 1 was";
}

TEST(CornerExponents, StayBetweenNoiseAndASmoothSolution)
{
  EXPECT_EQ(learned(5.0, 1.0, 0.5), degree + 1.0);
  EXPECT_GT(learned(0.01, 1.0, 0.5), 0.5);
}

TEST(CornerExponents, AreKeptWhereAVertexIsNotRefinedAgain)
{
  CornerExponents exponents(degree);
  const Mesh coarse = fan(1.0), fine = fan(0.5);
  exponents.observe({&coarse}, {contributionsOf(1.0, 0.8)});
  exponents.observe({&fine}, {contributionsOf(0.5, 0.8)});
  exponents.observe({&fine}, {contributionsOf(0.5, 2.0)});
  EXPECT_NEAR(exponents.exponents()[0][0], 0.8, 1e-12);
}
