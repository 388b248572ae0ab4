// Points of a body: where they lie, and what a solution is there.

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "ndframe/assembly/nodal_stress.hpp"
#include "ndframe/assembly/point_values.hpp"

namespace ndframe
{
namespace
{

Mesh meshOf(int dim)
{
  return dim == 2 ? test::shaken(test::box({4, 3}, "Alternating", 0.0, {2.0, 1.0}), 0.05, 1)
                  : test::shaken(test::box({2, 2, 2}, "Right", 0.0, {2.0, 1.0, 1.0}), 0.05, 1);
}

using Points = std::vector<std::vector<double>>;

/// Points inside of random cells, and what their coordinates are.
Points randomPoints(const Mesh& mesh, int count, std::vector<int>* cells = nullptr)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.05, 1.0);
  Points points;
  for (int i = 0; i < count; ++i) {
    PointInCell place;
    place.cell = int(random() % unsigned(mesh.numCells()));
    const auto end = place.lambda.begin() + mesh.dim + 1;
    std::generate(place.lambda.begin(), end, [&] { return share(random); });
    const double sum = std::accumulate(place.lambda.begin(), end, 0.0);
    std::for_each(place.lambda.begin(), end, [&](double& lambda) { lambda /= sum; });
    points.push_back(pointAt(mesh, place));
    if (cells != nullptr)
      cells->push_back(place.cell);
  }
  return points;
}

/// u is quadratic in x, the stress of order 2 exact for it.
void quadratic(const double* x, double* u)
{
  u[0] = 0.1 * x[0] * x[0] - 0.2 * x[0] * x[1];
  u[1] = 0.3 * x[1] + 0.05 * x[0] * x[1];
}
void linear(const double* x, double* u)
{
  u[0] = 0.1 * x[0] + 0.3 * x[1];
  u[1] = 0.2 * x[1];
}

} // namespace

struct CellsOfPoints : testing::TestWithParam<int>
{
  Mesh mesh = meshOf(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Dimensions, CellsOfPoints, testing::Values(2, 3), testing::PrintToStringParamName());

TEST_P(CellsOfPoints, FindTheCellOfAPointInside)
{
  std::vector<int> cells;
  const Points points = randomPoints(mesh, 200, &cells);
  const auto places = cellsOfPoints(mesh, points, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(places[i].size(), 1u);
    EXPECT_EQ(places[i][0].cell, cells[i]);
    const auto found = pointAt(mesh, places[i][0]);
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], points[i][k], 1e-14);
  }
}

TEST_P(CellsOfPoints, FindAllCellsAroundAVertex)
{
  Points points;
  for (int v = 0; v < mesh.numPoints(); ++v)
    points.emplace_back(mesh.point(v), mesh.point(v) + mesh.dim);
  const auto places = cellsOfPoints(mesh, points, 0.0);
  for (int v = 0; v < mesh.numPoints(); ++v) {
    std::vector<int> around, found;
    for (int c = 0; c < mesh.numCells(); ++c)
      if (std::count(mesh.cell(c), mesh.cell(c) + mesh.dim + 1, v) > 0)
        around.push_back(c);
    for (const PointInCell& place : places[std::size_t(v)])
      found.push_back(place.cell);
    EXPECT_EQ(found, around);
  }
}

TEST_P(CellsOfPoints, TakeThePointsOneByOneOrTogether)
{
  const Points points = randomPoints(mesh, 30);
  const auto together = cellsOfPoints(mesh, points, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(cellsOfPoints(mesh, {points[i]}, 0.0)[0][0].cell, together[i][0].cell);
}

TEST_P(CellsOfPoints, ReachOutsideAsFarAsTheTolerance)
{
  const Mesh box = GetParam() == 2 ? test::box({3, 3}, "Right", 0.0, {1.0, 1.0})
                                   : test::box({2, 2, 2}, "Right", 0.0, {1.0, 1.0, 1.0});
  std::vector<double> beside(std::size_t(box.dim), 0.4);
  beside[0] = 1.01;
  EXPECT_TRUE(cellsOfPoints(box, {beside}, 0.009)[0].empty());
  const auto found = cellsOfPoints(box, {beside}, 0.011)[0];
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(*std::min_element(found[0].lambda.begin(), found[0].lambda.end()), 0.0);
  EXPECT_NEAR(pointAt(box, found[0])[0], 1.01, 1e-14);
}

struct PointValuesOf : testing::TestWithParam<std::tuple<int, int>>
{
  int dim = std::get<0>(GetParam()), order = std::get<1>(GetParam());
  BodyModel body = test::makeBody(meshOf(dim), order);
};
INSTANTIATE_TEST_SUITE_P(DimensionsAndOrders, PointValuesOf,
                         testing::Combine(testing::Values(2, 3), testing::Values(1, 2)));

TEST_P(PointValuesOf, FieldsThatTheElementsHoldAreExact)
{
  const auto field = order == 1 ? linear : quadratic;
  const Vector u = test::interpolate(body.nodes, field);
  const Points points = randomPoints(body.mesh, 50);
  const auto places = cellsOfPoints(body.mesh, points, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double exact[3] = {};
    field(points[i].data(), exact);
    const PointValues values = valuesAt(body, u, u, places[i]);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(values.displacement[k], exact[k], 1e-14);
  }
}

TEST_P(PointValuesOf, StressAtAVertexIsThatOfTheNodes)
{
  const Vector u = test::interpolate(body.nodes, [](const double* x, double* v) {
    v[0] = x[0] * x[0] * x[1];
    v[1] = x[1] * x[1] * x[1] - x[0];
  });
  const auto atNodes = nodalStress(body, u);
  for (int v = 0; v < body.mesh.numPoints(); ++v) {
    const std::vector<double> point(body.mesh.point(v), body.mesh.point(v) + dim);
    const PointValues values = valuesAt(body, u, u, cellsOfPoints(body.mesh, {point}, 0.0)[0]);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(values.stress[c], atNodes[std::size_t(v)][c], 1e-12);
  }
}

TEST_P(PointValuesOf, StressDoesNotSeeRigidMotionsOfTheDisplacement)
{
  const Vector strained = test::interpolate(body.nodes, linear), moved(strained.size(), 5.0);
  const auto place = cellsOfPoints(body.mesh, randomPoints(body.mesh, 1), 0.0)[0];
  EXPECT_EQ(valuesAt(body, moved, strained, place).stress, valuesAt(body, strained, strained, place).stress);
  EXPECT_NEAR(valuesAt(body, moved, strained, place).displacement[0], 5.0, 1e-14);
}

TEST_P(PointValuesOf, ForcesOfAllSidesOfAUniformStressAreInBalance)
{
  const Vector u = test::interpolate(body.nodes, linear);
  const std::array<double, 3> origin{};
  std::array<double, 3> force{}, moment{};
  double measure = 0.0;
  for (const Side& side : body.mesh.sides) {
    const SideIntegrals integrals = integrateSide(body, side, u, u);
    const auto about = integrals.momentAbout(origin);
    measure += integrals.measure;
    for (std::size_t k = 0; k < 3; ++k) {
      force[k] += integrals.force[k];
      moment[k] += about[k];
    }
  }
  EXPECT_GT(measure, 5.9);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(force[k], 0.0, 1e-13);
    EXPECT_NEAR(moment[k], 0.0, 1e-13);
  }
}

TEST_P(PointValuesOf, MeanAndCentreOfASide)
{
  const Mesh box =
      dim == 2 ? test::box({3, 3}, "Right", 0.0, {2.0, 1.0}) : test::box({2, 2, 2}, "Right", 0.0, {2.0, 1.0, 1.0});
  const BodyModel straight = test::makeBody(box, order);
  const Vector u = test::interpolate(straight.nodes, linear);
  const SideIntegrals right = integrateSide(straight, *straight.side("right"), u, u);
  EXPECT_NEAR(right.measure, 1.0, 1e-14);
  EXPECT_NEAR(right.centre[0], 2.0, 1e-14);
  EXPECT_NEAR(right.centre[1], 0.5, 1e-14);
  EXPECT_NEAR(right.displacement[0], 0.2 + 0.15, 1e-14);
  const auto stress =
      valuesAt(straight, u, u, cellsOfPoints(box, {std::vector<double>(std::size_t(dim), 0.4)}, 0.0)[0]).stress;
  EXPECT_NEAR(right.force[0], stress[0], 1e-13);
  EXPECT_NEAR(right.force[1], stress[3], 1e-13);
  EXPECT_NEAR(right.moment[2], 0.0, 1e-13);
  EXPECT_NEAR(right.momentAbout({0.0, 0.0, 0.0})[2], 2.0 * stress[3] - 0.5 * stress[0], 1e-13);
}

} // namespace ndframe
