#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"
#include "ndframe/interface/normal_field.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A box of 0 < x, y < 1 mapped onto a part of a hollow cylinder of the radius 2 + z.
BodyModel onCylinder(BodyModel body, double uneven)
{
  for (int p = 0; p < body.mesh.numPoints(); ++p) {
    double* x = body.mesh.points.data() + std::ptrdiff_t(p) * 3;
    const double angle = 1.2 * (x[0] + uneven * std::sin(6.28 * x[0])), radius = 2.0 + x[2];
    x[0] = radius * std::sin(angle);
    x[2] = radius * std::cos(angle);
  }
  body.nodes = makeNodeMap(body.mesh, body.nodes.order);
  return body;
}

/// Two bodies that touch along the cylinder of radius 2.
struct Shells
{
  explicit Shells(double uneven = 0.0, int order = 2)
      : upper(onCylinder(boxBody("upper", box("0, 0, 0", "1, 1, 1", "5, 2, 1"), order), uneven)),
        lower(onCylinder(boxBody("lower", box("0, 0, -1", "1, 1, 0", "5, 2, 1"), order), uneven))
  {}

  InterfaceMesh pair(double cornerAngle = 35.0) const
  {
    return pairSides(interfaceEntry("bottom", "top", "0", cornerAngle), upper, lower);
  }

  BodyModel upper, lower;
};

/// n and the point at barycentric coordinates of a facet.
std::pair<Direction, Direction> at(const InterfaceMesh& mesh, int facet, const std::array<double, 3>& lambda)
{
  Direction n{}, x{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] += lambda[a] * mesh.endNormals[std::size_t(facet)][a][k];
      x[k] += lambda[a] * mesh.point(mesh.nodesOf(facet)[a])[k];
    }
  return {n, x};
}

void expectRadius(const Direction& n, const double* x, double length)
{
  EXPECT_NEAR(n[0], x[0] / length, 1e-12);
  EXPECT_NEAR(n[1], 0.0, 1e-12);
  EXPECT_NEAR(n[2], x[2] / length, 1e-12);
}

} // namespace

TEST(NormalFieldOfSolids, IsTheRadiusOfACylinderEverywhere)
{
  for (const int order : {1, 2}) {
    const InterfaceMesh mesh = Shells(0.0, order).pair();
    const double length = -2.0 * std::cos(0.12);
    ASSERT_EQ(int(mesh.endNormals.size()), mesh.numFacets());
    for (int f = 0; f < mesh.numFacets(); ++f)
      for (const auto& lambda : {std::array{1.0, 0.0, 0.0}, std::array{0.2, 0.3, 0.5}}) {
        const auto [n, x] = at(mesh, f, lambda);
        expectRadius(n, x.data(), length);
      }
    for (int i = 0; i < mesh.numNodes(); ++i)
      expectRadius(mesh.normals[std::size_t(i)], mesh.point(i), length);
  }
}

TEST(NormalFieldOfSolids, KeepsTheFacetsOwnAtCornersAndWithAnAngleOfZero)
{
  EXPECT_TRUE(Shells().pair(0.0).endNormals.empty());
  EXPECT_TRUE(Shells().pair(13.0).endNormals.empty()); // facets turn by 13.75 degrees
  EXPECT_FALSE(Shells().pair(14.0).endNormals.empty());
}

TEST(NormalFieldOfSolids, FinerMeshesOfThePolyhedronInheritTheFunction)
{
  for (const bool exchanged : {false, true}) {
    Shells shells(0.05);
    const InterfaceMesh first = shells.pair();
    for (BodyModel* body : {&shells.upper, &shells.lower})
      refine(*body);
    InterfaceMesh fine =
        exchanged ? pairSides(interfaceEntry("top", "bottom"), shells.lower, shells.upper) : shells.pair();
    ASSERT_TRUE(inheritNormals(fine, first));
    ASSERT_EQ(fine.numFacets(), 4 * first.numFacets());
    int found = 0;
    for (int f = 0; f < fine.numFacets(); ++f)
      for (int parent = 0; parent < first.numFacets(); ++parent) {
        double distance = 0.0;
        for (const std::array<double, 3>& lambda :
             {std::array{0.5, 0.5, 0.0}, std::array{0.0, 0.5, 0.5}, std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}})
        {
          const auto [n, x] = at(fine, f, lambda);
          // the coordinates in the parent, by areas in its plane
          Direction corner[3];
          for (std::size_t a = 0; a < 3; ++a)
            corner[a] = at(first, parent, {a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0}).second;
          const auto area = [](const Direction& a, const Direction& b, const Direction& c) {
            const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
            return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
          };
          const double all = area(corner[0], corner[1], corner[2]);
          const std::array<double, 3> place{area(x, corner[1], corner[2]) / all, area(corner[0], x, corner[2]) / all,
                                            area(corner[0], corner[1], x) / all};
          distance = std::max(distance, std::abs(place[0] + place[1] + place[2] - 1.0));
          if (distance > 1e-9)
            break;
          const auto [expected, same] = at(first, parent, place);
          for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(same[k], x[k], 1e-12);
            EXPECT_NEAR(n[k], (exchanged ? -1.0 : 1.0) * expected[k], 1e-12);
          }
        }
        found += distance <= 1e-9;
      }
    EXPECT_EQ(found, fine.numFacets());
  }
}

TEST(NormalFieldOfSolids, OtherPolyhedraInheritNothing)
{
  const InterfaceMesh first = Shells(0.05).pair();
  InterfaceMesh other = Shells(0.06).pair();
  const auto before = other.endNormals;
  EXPECT_FALSE(inheritNormals(other, first));
  EXPECT_EQ(other.endNormals, before);
}
