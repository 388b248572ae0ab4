#include <cmath>

#include <gtest/gtest.h>

#include "ndframe/cutting/cannot_cut.hpp"
#include "ndframe/cutting/constrained_triangulation.hpp"

namespace ndframe
{
namespace
{

using Points = std::vector<std::array<double, 2>>;

double areaOf(const Points& points, const std::vector<std::array<int, 3>>& triangles)
{
  double area = 0.0;
  for (const auto& t : triangles) {
    const auto &a = points[std::size_t(t[0])], &b = points[std::size_t(t[1])], &c = points[std::size_t(t[2])];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

bool hasEdge(const std::vector<std::array<int, 3>>& triangles, int a, int b)
{
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if ((t[k] == a && t[(k + 1) % 3] == b) || (t[k] == b && t[(k + 1) % 3] == a))
        return true;
  return false;
}

TEST(ConstrainedTriangulation, HasItsSegmentsAndCoversTheHull)
{
  const Points points{{0, 0}, {3, 0}, {3, 1}, {0, 1}, {1.5, 0.5}};
  const auto free = constrainedTriangulation(points, {});
  const auto held = constrainedTriangulation(points, {{0, 4}, {4, 2}, {2, 4}, {0, 1}});
  for (const auto* triangles : {&free, &held})
    EXPECT_NEAR(areaOf(points, *triangles), 3.0, 1e-15);
  EXPECT_TRUE(hasEdge(held, 0, 4) && hasEdge(held, 4, 2) && hasEdge(held, 0, 1));
}

TEST(ConstrainedTriangulation, TakesPointsThatAreNearlyOnALine)
{
  Points points{{0, 0}, {1, 0}, {0.5, 1}};
  std::vector<std::array<int, 2>> chain{{0, 3}};
  for (int i = 1; i < 10; ++i) {
    points.push_back({0.1 * i, (i % 2 == 0 ? 1e-17 : -1e-17)});
    if (i > 1)
      chain.push_back({i + 1, i + 2});
  }
  chain.push_back({11, 1});
  const auto triangles = constrainedTriangulation(points, chain);
  EXPECT_NEAR(areaOf(points, triangles), 0.5, 1e-14);
  for (const auto& [a, b] : chain)
    EXPECT_TRUE(hasEdge(triangles, a, b));
}

TEST(ConstrainedTriangulation, RefusesSegmentsThatCrossAndPointsThatAreOne)
{
  const Points points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_THROW(constrainedTriangulation(points, {{0, 2}, {1, 3}}), CannotCut);
  EXPECT_THROW(constrainedTriangulation({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {}), CannotCut);
}

} // namespace
} // namespace ndframe
