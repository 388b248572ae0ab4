#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "bisection_peaks.hpp"
#include "bisection_scenes.hpp"
#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/shape.hpp"

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

class BisectionShapesOfSquares : public BisectionShapes
{};

INSTANTIATE_TEST_SUITE_P(Bisection, BisectionShapesOfSquares, testing::ValuesIn(squareScenes()),
                         [](const auto& scene) { return scene.param.name; });

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

using Shapes = std::vector<std::array<double, 3>>;

/// Adds the shapes that the cells have and that are not yet known.
void collect(Shapes& known, const std::vector<Mesh>& meshes)
{
  for (const Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c) {
      const auto now = shape(mesh, c);
      const auto isNow = [&](const auto& s) {
        return std::equal(s.begin(), s.end(), now.begin(),
                          [](double a, double b) { return std::abs(a - b) < 1e-8 * b; });
      };
      if (std::none_of(known.begin(), known.end(), isNow))
        known.push_back(now);
    }
}

/// The shapes after many halvings here and there and towards a corner.
Shapes shapesOfMany(Bisection bisection)
{
  const std::vector<double> corner(bisection.meshes()[0].point(0), bisection.meshes()[0].point(0) + 2);
  Shapes shapes;
  for (unsigned round = 0; round < 4; ++round) {
    bisection.refine(randomHalvings(bisection.meshes(), round, 6));
    collect(shapes, bisection.meshes());
    bisection.refine(halvingsAt(bisection.meshes(), corner[0], corner[1], 4));
    collect(shapes, bisection.meshes());
  }
  return shapes;
}

TEST_P(BisectionShapesOfSquares, HalfSquaresRemainHalfSquares)
{
  EXPECT_EQ(shapesOfMany(Bisection(start(), twins())).size(), 1U);
}

TEST(BisectionShapes, EquilateralTrianglesHaveFewShapes)
{
  EXPECT_LE(shapesOfMany(Bisection({equilateral(4)}, {})).size(), 12U);
}

double worstShapeOf(const std::vector<Mesh>& meshes)
{
  double worst = 1.0;
  for (const Mesh& mesh : meshes)
    worst = std::min(worst, worstShape(mesh));
  return worst;
}

double smallestAngleOf(const std::vector<Mesh>& meshes)
{
  double smallest = M_PI;
  for (const Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c)
      smallest = std::min(smallest, smallestAngle(mesh, c));
  return smallest;
}

/// The worst shape that newest-vertex bisection alone would make.
double worstToCome(const std::vector<Mesh>& meshes)
{
  double worst = 1.0;
  for (const Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c) {
      const int* v = mesh.cell(c);
      const Corners corners{mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])};
      worst = std::min(worst, worstDescendant(corners, longestPeak(corners)));
    }
  return worst;
}

/// The bound of the angles is not proved: shapes are what is compared.
TEST_P(BisectionShapes, MendingMakesNoWorseCellsThanHalvingAlone)
{
  Bisection bisection(start(), twins());
  const double worst = (1 - 1e-6) * worstToCome(start()), angle = (1 - 1e-8) * 0.5 * smallestAngleOf(start());
  const double* corner = start()[0].point(0);
  for (unsigned round = 0; round < 12; ++round) {
    bisection.refine(round % 2 == 0 ? randomHalvings(bisection.meshes(), round, 4)
                                    : halvingsAt(bisection.meshes(), corner[0], corner[1], 3));
    EXPECT_GE(worstToCome(bisection.meshes()), worst);
    EXPECT_GE(worstShapeOf(bisection.meshes()), worst);
    EXPECT_GE(smallestAngleOf(bisection.meshes()), angle);
  }
}

TEST(BisectionShapes, MendingOfSmallMeshesMakesNoWorseCellsThanHalvingAlone)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.2, 1.5);
  for (int k = 0; k < 300; ++k) {
    const double middle = place(random);
    const Mesh kite{2, {0, 0, place(random), -place(random), 2, 0, middle, place(random)}, {0, 1, 2, 0, 2, 3}, {}, {}};
    Bisection bisection({kite}, {});
    for (unsigned round = 0; round < 4; ++round) {
      bisection.refine(randomHalvings(bisection.meshes(), round, 3));
      EXPECT_GE(worstToCome(bisection.meshes()), (1 - 1e-6) * worstToCome({kite})) << k;
    }
  }
}

/// By area.
double meanShape(const std::vector<Mesh>& meshes)
{
  double sum = 0.0, area = 0.0;
  for (const Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c) {
      const int* v = mesh.cell(c);
      sum += cellMeasure(mesh, c) * triangleShape(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
      area += cellMeasure(mesh, c);
    }
  return sum / area;
}

TEST_P(BisectionShapes, StretchedCellsBecomeRound)
{
  Bisection bisection(start(), twins());
  for (int call = 0; call < 8; ++call)
    bisection.refine(sameHalvings(bisection.meshes(), 1));
  EXPECT_GE(meanShape(bisection.meshes()), 0.8) << "at first " << meanShape(start());
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
  EXPECT_LE(first, 12.0);
  EXPECT_LE(addHalvings(20), first + 0.5);
}

TEST(BisectionShapes, DoNotDependOnUnitsOrRotation)
{
  for (const Bodies& bodies : bisectionScenes()) {
    if (bodies.name != "Bent" && bodies.name != "Jittered" && bodies.name != "Flat" && bodies.name != "GmshFile")
      continue; // nothing there is equally long, which position would decide
    std::vector<Mesh> turned = bodies.meshes;
    for (Mesh& mesh : turned)
      for (int p = 0; p < mesh.numPoints(); ++p) {
        double* x = mesh.points.data() + 2 * p;
        const double old[2] = {x[0], x[1]};
        x[0] = 1e3 * (0.28 * old[0] - 0.96 * old[1]);
        x[1] = 1e3 * (0.96 * old[0] + 0.28 * old[1]);
      }
    Bisection here(bodies.meshes, findTwins(bodies.meshes)), there(turned, findTwins(turned));
    for (unsigned round = 0; round < 3; ++round) {
      const auto halvings = randomHalvings(here.meshes(), round, 6);
      here.refine(halvings);
      there.refine(halvings);
      for (std::size_t m = 0; m < turned.size(); ++m)
        ASSERT_EQ(there.meshes()[m].cells, here.meshes()[m].cells) << bodies.name;
    }
  }
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

TEST_P(BisectionShapesOfSquares, RegularGridsStayRegular)
{
  Bisection bisection(start(), twins());
  for (int call = 1; call <= 4; ++call) {
    bisection.refine(sameHalvings(bisection.meshes(), 1));
    for (std::size_t m = 0; m < start().size(); ++m)
      EXPECT_EQ(bisection.meshes()[m].numCells(), start()[m].numCells() << call);
  }
}

} // namespace
