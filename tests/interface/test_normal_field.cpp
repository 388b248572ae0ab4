#include "ndframe/interface/normal_field.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

using Map = std::function<std::array<double, 2>(double x, double y)>;

BodyModel mapped(BodyModel body, const Map& map)
{
  for (int p = 0; p < body.mesh.numPoints(); ++p) {
    double* x = body.mesh.points.data() + p * 2;
    const auto moved = map(x[0], x[1]);
    std::copy(moved.begin(), moved.end(), x);
  }
  body.nodes = makeNodeMap(body.mesh, body.nodes.order);
  return body;
}

/// Two bodies of 0 < x < 1 that touch along y = 0, mapped.
struct Bodies
{
  Bodies(const Map& map, int cells, int order = 2)
      : upper(mapped(boxBody("upper", box("0, 0", "1, 1", std::to_string(cells) + ", 2"), order), map)),
        lower(mapped(boxBody("lower", box("0, -1", "1, 0", std::to_string(cells) + ", 2"), order), map))
  {}

  InterfaceMesh pair(double cornerAngle = 35.0) const
  {
    return pairSides(interfaceEntry("bottom", "top", "0", cornerAngle), upper, lower);
  }

  BodyModel upper, lower;
};

std::array<double, 2> onRing(double angle, double y)
{
  return {-(2.0 + y) * std::cos(angle), (2.0 + y) * std::sin(angle)};
}

/// A part of a ring of radius 2 around the origin.
std::array<double, 2> ring(double x, double y)
{
  return onRing(1.5 * x, y);
}

/// The same with cells of very different lengths.
std::array<double, 2> unequalRing(double x, double y)
{
  return onRing(1.5 * (x + 0.15 * std::sin(6.0 * x)), y);
}

Map kink(double slope, double at = 0.5)
{
  return [=](double x, double y) { return std::array{x, y + slope * std::max(0.0, x - at)}; };
}

/// n at a point of a facet, from its first vertex to its second.
Direction at(const InterfaceMesh& mesh, int facet, double t)
{
  const auto& ends = mesh.endNormals[std::size_t(facet)];
  return {(1.0 - t) * ends[0][0] + t * ends[1][0], (1.0 - t) * ends[0][1] + t * ends[1][1], 0.0};
}

std::array<double, 2> pointOn(const InterfaceMesh& mesh, int facet, double t)
{
  const int nodes = mesh.nodesPerFacet();
  const double *a = mesh.point(mesh.facets[std::size_t(facet * nodes)]),
               *b = mesh.point(mesh.facets[std::size_t(facet * nodes + 1)]);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

} // namespace

TEST(NormalField, IsTheRadiusOfACircleEverywhere)
{
  // so a body that turns in a ring slips without opening, and the traction n has the facet's pressure 1
  const InterfaceMesh mesh = Bodies(ring, 8).pair();
  const double apothem = 2.0 * std::cos(1.5 / 16.0);
  ASSERT_EQ(int(mesh.endNormals.size()), mesh.numFacets());
  for (int f = 0; f < mesh.numFacets(); ++f)
    for (const double t : {0.0, 0.3, 1.0}) {
      const auto x = pointOn(mesh, f, t);
      const Direction n = at(mesh, f, t);
      EXPECT_NEAR(n[0], -x[0] / apothem, 1e-13);
      EXPECT_NEAR(n[1], -x[1] / apothem, 1e-13);
    }
  for (int i = 0; i < mesh.numNodes(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(mesh.normals[std::size_t(i)][k], -mesh.point(i)[k] / apothem, 1e-13);
}

TEST(NormalField, PointsAlongTheRadiusAtTheVerticesOfAnyChords)
{
  const InterfaceMesh mesh = Bodies(unequalRing, 8).pair();
  ASSERT_EQ(int(mesh.endNormals.size()), mesh.numFacets());
  for (int f = 0; f < mesh.numFacets(); ++f)
    for (const double end : {0.0, 1.0}) {
      const auto x = pointOn(mesh, f, end);
      const Direction n = at(mesh, f, end);
      EXPECT_NEAR(n[0] * x[1], n[1] * x[0], 1e-13);
      EXPECT_LT(n[0] * x[0] + n[1] * x[1], -2.0);
      EXPECT_GT(n[0] * x[0] + n[1] * x[1], -2.05);
    }
}

TEST(NormalField, FinerMeshesOfThePolygonInheritTheFunction)
{
  for (const bool exchanged : {false, true}) {
    Bodies bodies(ring, 6);
    const InterfaceMesh first = bodies.pair();
    for (BodyModel* body : {&bodies.upper, &bodies.lower, &bodies.upper, &bodies.lower})
      refine(*body);
    InterfaceMesh fine =
        exchanged ? pairSides(interfaceEntry("top", "bottom"), bodies.lower, bodies.upper) : bodies.pair();
    ASSERT_TRUE(inheritNormals(fine, first));
    const double length = 2.0 * std::cos(1.5 / 12.0), sign = (exchanged ? 1.0 : -1.0) / length;
    for (int f = 0; f < fine.numFacets(); ++f)
      for (const double t : {0.0, 0.5, 1.0})
        for (std::size_t k = 0; k < 2; ++k)
          EXPECT_NEAR(at(fine, f, t)[k], sign * pointOn(fine, f, t)[k], 1e-12);
    for (int i = 0; i < fine.numNodes(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(fine.normals[std::size_t(i)][k], sign * fine.point(i)[k], 1e-12);
  }
}

TEST(NormalField, TheSameMeshInheritsTheSameBits)
{
  const Bodies bodies(unequalRing, 6);
  const InterfaceMesh first = bodies.pair();
  InterfaceMesh again = bodies.pair();
  ASSERT_TRUE(inheritNormals(again, first));
  EXPECT_EQ(again.endNormals, first.endNormals);
  EXPECT_EQ(again.normals, first.normals);
}

TEST(NormalField, AnotherPolygonInheritsNothing)
{
  const InterfaceMesh first = Bodies(ring, 6).pair();
  InterfaceMesh other = Bodies(ring, 9).pair();
  const auto before = other.endNormals;
  EXPECT_FALSE(inheritNormals(other, first));
  EXPECT_EQ(other.endNormals, before);
}

TEST(NormalField, StraightSidesKeepTheirNormals)
{
  for (const double slope : {0.0, 0.7}) {
    const Bodies bodies([=](double x, double y) { return std::array{x - slope * y, y + slope * x}; }, 5);
    const InterfaceMesh mesh = bodies.pair();
    EXPECT_TRUE(mesh.endNormals.empty());
    EXPECT_EQ(mesh.normals, bodies.pair(0.0).normals);
  }
}

TEST(NormalField, TurnsOverAKinkThatIsBelowTheCornerAngle)
{
  const double angle = 20.0 * std::acos(-1.0) / 180.0;
  const InterfaceMesh mesh = Bodies(kink(std::tan(angle)), 4).pair();
  ASSERT_EQ(mesh.endNormals.size(), 4u);
  int turning = 0;
  for (int f = 0; f < 4; ++f) {
    if (dotProduct(mesh.endNormals[std::size_t(f)][0], mesh.endNormals[std::size_t(f)][0]) == 0.0)
      continue;
    ++turning;
    for (const double end : {0.0, 1.0}) {
      const double x = pointOn(mesh, f, end)[0], length = std::hypot(0.25, 0.25 * std::tan(angle));
      // the tangent of the circle: the facets' angles weighted by each other's lengths
      const double between = std::atan2(0.25 * std::sin(angle), length + 0.25 * std::cos(angle));
      const double expected = x < 0.4 ? 0.0 : x > 0.6 ? angle : between;
      const Direction n = at(mesh, f, end);
      EXPECT_NEAR(std::atan2(n[0], -n[1]), expected, 1e-13);
      EXPECT_NEAR(std::hypot(n[0], n[1]),
                  std::abs(x - 0.5) > 0.1 ? 1.0 : 2.0 / (std::cos(between) + std::cos(angle - between)), 1e-13);
    }
  }
  EXPECT_EQ(turning, 2);
}

TEST(NormalField, FacetsBesideACornerKeepTheirOwn)
{
  const Bodies bodies(kink(1.0), 4);
  EXPECT_TRUE(bodies.pair().endNormals.empty());
  EXPECT_FALSE(bodies.pair(50.0).endNormals.empty());
  EXPECT_TRUE(Bodies(ring, 8).pair(0.0).endNormals.empty());
}
