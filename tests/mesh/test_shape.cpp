#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "bisection_peaks.hpp"
#include "ndframe/mesh/shape.hpp"

namespace
{

using namespace ndframe;

using Triangle = std::array<std::array<double, 2>, 3>;

double shapeOf(const Triangle& t)
{
  return triangleShape(t[0].data(), t[1].data(), t[2].data());
}

Corners cornersOf(const Triangle& t)
{
  return {t[0].data(), t[1].data(), t[2].data()};
}

std::array<double, 2> middle(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}

/// A hundred triangles, some of them very flat.
std::vector<Triangle> someTriangles()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<Triangle> triangles;
  while (triangles.size() < 100) {
    const double height = std::pow(10.0, place(random) - 1.0);
    const Triangle t{{{place(random), height * place(random)},
                      {place(random), height * place(random)},
                      {place(random), height * place(random)}}};
    if (shapeOf(t) > 0.0)
      triangles.push_back(t);
  }
  return triangles;
}

TEST(Shape, OfKnownTriangles)
{
  EXPECT_NEAR(shapeOf({{{0, 0}, {2, 0}, {1, std::sqrt(3.0)}}}), 1.0, 1e-14);
  EXPECT_NEAR(shapeOf({{{0, 0}, {1, 0}, {0, 1}}}), std::sqrt(3.0) / 2, 1e-14);
  EXPECT_NEAR(shapeOf({{{0, 0}, {4, 0}, {0, 1}}}), 8 * std::sqrt(3.0) / 34, 1e-14);
  EXPECT_EQ(shapeOf({{{0, 0}, {1, 0}, {3, 0}}}), 0.0);
  EXPECT_NEAR(shapeOf({{{0, 0}, {0, 1}, {1, 0}}}), -std::sqrt(3.0) / 2, 1e-14);
}

TEST(Shape, OfAMeshIsThatOfItsWorstCell)
{
  EXPECT_NEAR(worstShape({2, {0, 0, 2, 0, 1, std::sqrt(3.0), 1, -0.1}, {0, 1, 2, 0, 3, 1}, {}, {}}),
              4 * std::sqrt(3.0) * 0.1 / (4 + 2 * 1.01), 1e-14);
  EXPECT_EQ(worstShape({2, {}, {}, {}, {}}), 1.0);
}

TEST(Shape, OfKnownTetrahedra)
{
  const double o[] = {0, 0, 0}, x[] = {1, 0, 0}, y[] = {0, 1, 0}, z[] = {0, 0, 1}, xy[] = {1, 1, 0}, xyz[] = {1, 1, 1};
  const double xz[] = {1, 0, 1}, yz[] = {0, 1, 1};
  EXPECT_NEAR(tetrahedronShape(o, xy, yz, xz), 1.0, 1e-14);
  EXPECT_NEAR(tetrahedronShape(o, x, xy, xyz), 1.2 * std::cbrt(0.25), 1e-14); // a sixth of a cube
  EXPECT_NEAR(tetrahedronShape(o, x, y, z), 12.0 / 9.0 * std::cbrt(0.25), 1e-14);
  EXPECT_NEAR(tetrahedronShape(x, o, y, z), -12.0 / 9.0 * std::cbrt(0.25), 1e-14);
  EXPECT_EQ(tetrahedronShape(o, x, y, xy), 0.0);
  EXPECT_NEAR(worstShape({3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1, 0, 0, 0.1}, {0, 1, 2, 3, 0, 1, 2, 4}, {}, {}}),
              12.0 * std::cbrt(0.0025) / (1 + 1 + 2 + 0.01 + 1.01 + 2.01), 1e-14);
}

TEST(Shape, DoesNotDependOnUnitsPlaceOrFirstCorner)
{
  for (const Triangle& t : someTriangles()) {
    Triangle moved;
    for (std::size_t k = 0; k < 3; ++k)
      moved[(k + 1) % 3] = {-1e3 * t[k][1] + 500.0, 1e3 * t[k][0]}; // turned by a right angle
    EXPECT_NEAR(shapeOf(moved) / shapeOf(t), 1.0, 1e-9);
  }
}

TEST(Shape, BoundsTheSmallestAngle)
{
  for (const Triangle& t : someTriangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &o = t[k], &a = t[(k + 1) % 3], &b = t[(k + 2) % 3];
      const double angle = std::atan2((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]),
                                      (a[0] - o[0]) * (b[0] - o[0]) + (a[1] - o[1]) * (b[1] - o[1]));
      EXPECT_GE(std::sqrt(3.0) * std::sin(angle) / (2 - std::cos(angle)), (1 - 1e-12) * shapeOf(t));
    }
}

/// The worst shape of a triangle, with the peak as its first corner, and of its descendants of so many generations.
double worstOf(const Triangle& t, int generations)
{
  if (generations == 0)
    return shapeOf(t);
  const auto m = middle(t[1], t[2]);
  return std::min({shapeOf(t), worstOf({m, t[0], t[1]}, generations - 1), worstOf({m, t[2], t[0]}, generations - 1)});
}

TEST(Shape, TheWorstDescendantIsFoundByHalving)
{
  for (const Triangle& t : someTriangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const double worst = worstOf({t[k], t[(k + 1) % 3], t[(k + 2) % 3]}, 6);
      EXPECT_NEAR(worstDescendant(cornersOf(t), int(k)) / worst, 1.0, 1e-9);
    }
}

TEST(Shape, TheLongestEdgeHasTheBestDescendants)
{
  for (const Triangle& t : someTriangles()) {
    const double best = worstDescendant(cornersOf(t), longestPeak(cornersOf(t)));
    EXPECT_GE(best, (0.6 - 1e-12) * shapeOf(t));
    EXPECT_LE(best, std::sqrt(3.0) / 2 + 1e-12);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(worstDescendant(cornersOf(t), k), best * (1 + 1e-12));
      const double mended = worstDescendant(cornersOf(t), mendedPeak(cornersOf(t), k));
      EXPECT_GE(mended, best / clearly * (1 - 1e-12));
    }
  }
}

} // namespace
