#include "ndframe/adaptivity/edge_exponents.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "creases.hpp"
#include "solid_edge.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

using Edges = std::vector<std::array<int, 2>>;

/// What is learned at a vertex of the edge from these contributions of two meshes.
double learnedBetween(double lambda, int halvings)
{
  const Mesh coarse = cubes(2), fine = halvedEverywhere(coarse, halvings);
  EdgeExponents exponents(solidDegree);
  exponents.observe({&coarse}, {edgeContributions(coarse, lambda)});
  exponents.observe({&fine}, {edgeContributions(fine, lambda)});
  const bool isSmooth = exponents.exponents()[0][0] > solidDegree + 0.99;
  EXPECT_EQ(exponents.directions()[0][0], (std::array<double, 3>{0.0, 0.0, isSmooth ? 0.0 : 1.0}));
  return exponents.exponents()[0][0];
}

} // namespace

TEST(Creases, OfABoxAreItsEdges)
{
  const Mesh mesh = cubes(3);
  const Edges creases = creasesOf(mesh);
  EXPECT_EQ(creases.size(), 36U);
  for (const auto& [a, b] : creases) {
    int onFaces = 0;
    for (int k = 0; k < 3; ++k)
      onFaces += mesh.point(a)[k] == mesh.point(b)[k] && (mesh.point(a)[k] == 0.0 || mesh.point(a)[k] == 1.0);
    EXPECT_EQ(onFaces, 2);
  }
}

TEST(Creases, AreWhereSidesChangeAndRegionsEnd)
{
  Mesh mesh = cubes(1);
  const std::size_t edges = creasesOf(mesh).size();
  const auto isOnBottom = [&](Facet facet) { return facetCentre(mesh, facet)[2] == 0.0; };
  for (int c = 0; c < 6 && mesh.sides.empty(); ++c)
    for (int k = 0; k < 4 && mesh.sides.empty(); ++k)
      if (isOnBottom({c, k}))
        mesh.sides.push_back({"half of the bottom", {{c, k}}});
  EXPECT_EQ(creasesOf(mesh).size(), edges + 1);
  mesh.sides.clear();
  mesh.groups.names = {{}, {"core"}};
  mesh.groups.kind = {1, 0, 0, 0, 0, 0}; // its two facets inside meet at the cube's diagonal and end on two faces
  EXPECT_EQ(creasesOf(mesh).size(), edges + 3);
}

TEST(EdgeExponents, AreFoundFromTwoMeshes)
{
  for (const double lambda : {0.55, 0.774, 1.0, 1.4, 2.0})
    for (const int halvings : {3, 6})
      EXPECT_NEAR(learnedBetween(lambda, halvings), lambda, 1e-3) << halvings;
}

TEST(EdgeExponents, StayBetweenACrackAndASmoothSolution)
{
  EXPECT_EQ(learnedBetween(0.1, 3), 0.5);
  EXPECT_EQ(learnedBetween(5.0, 3), solidDegree + 1.0);
}

TEST(EdgeExponents, AreThoseOfASmoothSolutionUntilSomethingIsLearned)
{
  const Mesh coarse = cubes(2), fine = halvedEverywhere(coarse, 3);
  EdgeExponents exponents(solidDegree);
  EXPECT_FALSE(exponents.knowsAny());
  for (int times = 0; times < 2; ++times) {
    exponents.observe({&coarse}, {edgeContributions(coarse, 0.6)});
    EXPECT_FALSE(exponents.knowsAny());
  }
  exponents.observe({&fine}, {edgeContributions(fine, 0.6)});
  EXPECT_TRUE(exponents.knowsAny());
  exponents.observe({&fine}, {edgeContributions(fine, 0.6)}, true); // nothing can be learned from here
  EXPECT_FALSE(exponents.knowsAny());
}

TEST(EdgeExponents, AreNotLearnedFromCoarseMeshes)
{
  const Mesh coarse = cubes(2), fine = halvedEverywhere(coarse, 3), finer = halvedEverywhere(fine, 3);
  EdgeExponents exponents(solidDegree);
  exponents.observe({&coarse}, {edgeContributions(coarse, 0.6)}, true);
  exponents.observe({&fine}, {edgeContributions(fine, 0.6)});
  EXPECT_FALSE(exponents.knowsAny());
  exponents.observe({&finer}, {edgeContributions(finer, 0.6)});
  EXPECT_TRUE(exponents.knowsAny());
}

TEST(EdgeExponents, HoldForAllVerticesOfTheEdgeAndForNoneInside)
{
  const Mesh coarse = cubes(2), fine = halvedEverywhere(coarse, 6);
  EdgeExponents exponents(solidDegree);
  exponents.observe({&coarse}, {edgeContributions(coarse, 0.6)});
  exponents.observe({&fine}, {edgeContributions(fine, 0.6)});
  int onEdge = 0;
  for (int v = 0; v < fine.numPoints(); ++v) {
    const double* x = fine.point(v);
    const auto isEnd = [](double coordinate) { return coordinate == 0.0 || coordinate == 1.0; };
    if (x[0] == 0.0 && x[1] == 0.0) {
      ++onEdge;
      EXPECT_NEAR(exponents.exponents()[0][std::size_t(v)], 0.6, 1e-3);
    } else if (int(isEnd(x[0])) + int(isEnd(x[1])) + int(isEnd(x[2])) < 2) {
      EXPECT_EQ(exponents.exponents()[0][std::size_t(v)], solidDegree + 1.0);
    }
  }
  EXPECT_EQ(onEdge, 9);
}

TEST(EdgeExponents, AreLearnedFromMeshesMadeAnew)
{
  // No vertex of one mesh but those of the cube is one of the other's.
  for (const double lambda : {0.55, 0.77, 0.9}) {
    const Mesh coarse = cubes(3), fine = cubes(7);
    EdgeExponents exponents(solidDegree, EdgeExponents::Meshes::MadeAnew);
    exponents.observe({&coarse}, {edgeContributions(coarse, lambda)});
    exponents.observe({&fine}, {edgeContributions(fine, lambda)});
    for (int v = 0; v < fine.numPoints(); ++v) {
      const double* x = fine.point(v);
      if (x[0] == 0.0 && x[1] == 0.0)
        EXPECT_NEAR(exponents.exponents()[0][std::size_t(v)], lambda, 0.02) << x[2];
    }
    EXPECT_EQ(std::abs(exponents.directions()[0][0][2]), 1.0);
  }
}

TEST(EdgeExponents, OfARowOfEdgesAreOne)
{
  // Noise from edge to edge is averaged out along the row.
  const Mesh coarse = cubes(4), fine = cubes(9);
  Vector before = edgeContributions(coarse, 0.77), after = edgeContributions(fine, 0.77);
  for (std::size_t c = 0; c < before.size(); ++c)
    before[c] *= c % 2 == 0 ? 1.2 : 0.8;
  EdgeExponents exponents(solidDegree, EdgeExponents::Meshes::MadeAnew);
  exponents.observe({&coarse}, {before});
  exponents.observe({&fine}, {after});
  double first = 0.0;
  for (int v = 0; v < fine.numPoints(); ++v) {
    const double* x = fine.point(v);
    if (x[0] != 0.0 || x[1] != 0.0 || x[2] == 0.0 || x[2] == 1.0)
      continue;
    if (first == 0.0)
      first = exponents.exponents()[0][std::size_t(v)];
    EXPECT_EQ(exponents.exponents()[0][std::size_t(v)], first);
  }
  EXPECT_NEAR(first, 0.77, 0.05);
}
