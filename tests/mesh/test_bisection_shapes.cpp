#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "bisection_scenes.hpp"
#include "mesh_deck.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

class BisectionShapes : public testing::TestWithParam<Bodies>
{
protected:
  const std::vector<Mesh>& start() const { return GetParam().meshes; }
  std::vector<FacetTwin> twins() const { return findTwins(start()); }
};

INSTANTIATE_TEST_SUITE_P(Bisection, BisectionShapes, testing::ValuesIn(bisectionScenes()),
                         [](const auto& scene) { return scene.param.name; });

/// Per mesh and cell a cell of the first mesh, carried on to the parts of the last refine().
void carryOn(std::vector<std::vector<int>>& ancestors, const Bisection& bisection)
{
  for (std::size_t m = 0; m < ancestors.size(); ++m) {
    std::vector<int> ofParts;
    for (const int parent : bisection.parents()[m])
      ofParts.push_back(ancestors[m][std::size_t(parent)]);
    ancestors[m] = std::move(ofParts);
  }
}

std::vector<std::vector<int>> themselves(const std::vector<Mesh>& meshes)
{
  std::vector<std::vector<int>> cells;
  for (const Mesh& mesh : meshes) {
    cells.emplace_back();
    for (int c = 0; c < mesh.numCells(); ++c)
      cells.back().push_back(c);
  }
  return cells;
}

/// The squared edges in ascending order over the area: equal for similar triangles.
std::array<double, 3> shape(const Mesh& mesh, int cell)
{
  double x[6];
  cellPoints(mesh, cell, x);
  std::array<double, 3> squares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = 2 * k, b = 2 * ((k + 1) % 3);
    squares[k] = (std::pow(x[a] - x[b], 2) + std::pow(x[a + 1] - x[b + 1], 2)) / cellMeasure(mesh, cell);
  }
  std::sort(squares.begin(), squares.end());
  return squares;
}

TEST_P(BisectionShapes, DescendantsOfATriangleHaveAtMostFourShapes)
{
  Bisection bisection(start(), twins());
  auto ancestors = themselves(start());
  for (unsigned round = 0; round < 4; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), round, 6));
    carryOn(ancestors, bisection);
  }
  for (std::size_t m = 0; m < start().size(); ++m) {
    std::vector<std::vector<std::array<double, 3>>> shapes(std::size_t(start()[m].numCells()));
    for (int c = 0; c < bisection.meshes()[m].numCells(); ++c) {
      auto& known = shapes[std::size_t(ancestors[m][std::size_t(c)])];
      const auto now = shape(bisection.meshes()[m], c);
      const auto isNow = [&](const auto& s) {
        return std::equal(s.begin(), s.end(), now.begin(),
                          [](double a, double b) { return std::abs(a - b) < 1e-8 * b; });
      };
      if (std::none_of(known.begin(), known.end(), isNow))
        known.push_back(now);
    }
    for (const auto& known : shapes)
      EXPECT_LE(known.size(), 4U);
  }
}

TEST_P(BisectionShapes, AnglesStayAboveHalfTheFirstSmallest)
{
  Bisection bisection(start(), twins());
  auto ancestors = themselves(start());
  const double* corner = start()[0].point(0);
  for (int round = 0; round < 12; ++round) {
    bisection.refine(halvingsAt(bisection.meshes(), corner[0], corner[1], 2));
    carryOn(ancestors, bisection);
  }
  double ratio = 2.0;
  for (std::size_t m = 0; m < start().size(); ++m)
    for (int c = 0; c < bisection.meshes()[m].numCells(); ++c)
      ratio = std::min(ratio, smallestAngle(bisection.meshes()[m], c) /
                                  smallestAngle(start()[m], ancestors[m][std::size_t(c)]));
  EXPECT_GE(ratio, 0.5 - 1e-8); // as exact as edges are equally long
}

/// One halving of the first cell that touches the place.
std::vector<std::vector<int>> halvingOfOne(const std::vector<Mesh>& meshes, double x, double y)
{
  auto halvings = halvingsAt(meshes, x, y, 1);
  bool isFirst = true;
  for (auto& ofMesh : halvings)
    for (int& number : ofMesh)
      if (number == 1)
        number = std::exchange(isFirst, false);
  return halvings;
}

TEST_P(BisectionShapes, ClosureAddsAFewCellsAHalving)
{
  Bisection bisection(start(), twins());
  const auto addHalvings = [&](int number) {
    const double* place = start()[0].point(start()[0].numPoints() / 2);
    std::size_t before = 0, after = 0;
    for (const Mesh& mesh : bisection.meshes())
      before += std::size_t(mesh.numCells());
    for (int call = 0; call < number; ++call)
      bisection.refine(halvingOfOne(bisection.meshes(), place[0], place[1]));
    for (const Mesh& mesh : bisection.meshes())
      after += std::size_t(mesh.numCells());
    return double(after - before) / number;
  };
  // In the long run every halving goes once round the place, however small its cells have become.
  const double first = addHalvings(20);
  EXPECT_LE(first, 8.0);
  EXPECT_LE(addHalvings(20), first + 0.5);
}

TEST(BisectionShapes, MarkingACellOfARegularMeshDoesNotRunThroughIt)
{
  for (const int cell : {0, 399, 420, 421, 777}) {
    Bisection bisection({equilateral(20)}, {});
    auto halvings = sameHalvings(bisection.meshes(), 0);
    halvings[0][std::size_t(cell)] = 1;
    bisection.refine(halvings);
    EXPECT_LE(bisection.meshes()[0].numCells(), 800 + 4);
  }
}

TEST(BisectionShapes, RegularGridsStayRegular)
{
  for (const Bodies& bodies : bisectionScenes()) {
    if (bodies.name != "Right" && bodies.name != "Alternating" && bodies.name != "Crossed" && bodies.name != "Rotated")
      continue;
    Bisection bisection(bodies.meshes, findTwins(bodies.meshes));
    for (int call = 1; call <= 4; ++call) {
      bisection.refine(sameHalvings(bisection.meshes(), 1));
      for (std::size_t m = 0; m < bodies.meshes.size(); ++m)
        EXPECT_EQ(bisection.meshes()[m].numCells(), bodies.meshes[m].numCells() << call);
    }
  }
}

} // namespace
