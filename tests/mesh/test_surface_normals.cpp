#include "ndframe/mesh/surface_normals.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

using namespace ndframe;

namespace
{

using Vector3 = TriangleSurface::Vector3;
using Map = std::function<Vector3(double r, double q)>;

double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A grid of n x m squares, each of two triangles, mapped; the inner points are shaken by parts of a square.
TriangleSurface grid(int n, int m, const Map& map, double shake = 0.0)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> by(-shake, shake);
  TriangleSurface surface;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool isInside = i > 0 && i < n && j > 0 && j < m;
      const double r = i + (isInside ? by(random) : 0.0), q = j + (isInside ? by(random) : 0.0);
      surface.points.push_back(map(r / n, q / m));
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      surface.triangles.insert(surface.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  for (const auto& t : surface.triangles) {
    Vector3 u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = surface.points[std::size_t(t[1])][k] - surface.points[std::size_t(t[0])][k];
      v[k] = surface.points[std::size_t(t[2])][k] - surface.points[std::size_t(t[0])][k];
    }
    Vector3 n3{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(dot(n3, n3));
    for (double& component : n3)
      component /= length;
    surface.normals.push_back(n3);
  }
  return surface;
}

Vector3 onCylinder(double r, double q)
{
  return {2.0 * std::sin(1.5 * r), 3.0 * q, 2.0 * std::cos(1.5 * r)};
}

Vector3 onSphere(double r, double q)
{
  const double x = std::tan(1.2 * (r - 0.5)), y = std::tan(1.2 * (q - 0.5)), s = 2.0 / std::sqrt(1 + x * x + y * y);
  return {s * x, s * y, s};
}

/// A saddle, and its normal.
Vector3 onSaddle(double r, double q)
{
  return {r, q, 0.4 * std::sin(2.0 * r) - 0.3 * q * q * (1.0 + r)};
}

Vector3 saddleNormal(const Vector3& x)
{
  return {-0.8 * std::cos(2.0 * x[0]) + 0.3 * x[1] * x[1], 0.6 * x[1] * (1.0 + x[0]), 1.0};
}

struct Angles
{
  double largest = 0.0, mean = 0.0; ///< root mean square
};

/// The sines of the angles between n and a direction.
Angles anglesTo(const TriangleSurface& surface, const std::function<Vector3(const Vector3&)>& direction)
{
  const auto normals = turningNormals(surface, 35.0);
  EXPECT_EQ(normals.size(), surface.triangles.size());
  Angles angles;
  for (std::size_t t = 0; t < normals.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 d = direction(surface.points[std::size_t(surface.triangles[t][i])]);
      const Vector3& n = normals[t][i];
      double squared = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        squared += std::pow(d[k] * n[(k + 1) % 3] - d[(k + 1) % 3] * n[k], 2);
      squared /= dot(d, d) * dot(n, n);
      angles.largest = std::max(angles.largest, std::sqrt(squared));
      angles.mean += squared / double(3 * normals.size());
    }
  angles.mean = std::sqrt(angles.mean);
  return angles;
}

} // namespace

TEST(SurfaceNormals, AreTheRadiusOfARegularCylinderEverywhere)
{
  // so a pin that turns in its hole slips without opening: n . (omega x x) = 0 at every point of every triangle
  for (const auto& [n, m] : {std::pair{6, 3}, {6, 1}, {5, 2}}) {
    const TriangleSurface surface = grid(n, m, onCylinder);
    const auto normals = turningNormals(surface, 35.0);
    ASSERT_EQ(normals.size(), surface.triangles.size());
    const double apothem = 2.0 * std::cos(0.75 / n), sign = surface.normals[0][2] > 0.0 ? 1.0 : -1.0;
    for (std::size_t t = 0; t < normals.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& x = surface.points[std::size_t(surface.triangles[t][i])];
        EXPECT_NEAR(normals[t][i][0], sign * x[0] / apothem, 1e-12);
        EXPECT_NEAR(normals[t][i][1], 0.0, 1e-12);
        EXPECT_NEAR(normals[t][i][2], sign * x[2] / apothem, 1e-12);
      }
  }
}

TEST(SurfaceNormals, AreTheRadiusAtTheVerticesOfShakenCylindersAndSpheres)
{
  for (const int n : {4, 8, 16}) {
    EXPECT_LT(anglesTo(grid(n, n, onSphere, 0.25), [](const Vector3& x) { return x; }).largest, 1e-11) << n;
    const auto radius = [](const Vector3& x) { return Vector3{x[0], 0.0, x[2]}; };
    EXPECT_LT(anglesTo(grid(n, n, onCylinder, 0.25), radius).largest, 1e-11) << n;
  }
}

TEST(SurfaceNormals, ComeQuicklyNearThoseOfOtherSurfaces)
{
  const Angles coarse = anglesTo(grid(8, 8, onSaddle, 0.25), saddleNormal),
               fine = anglesTo(grid(32, 32, onSaddle, 0.25), saddleNormal);
  EXPECT_LT(coarse.largest, 0.05);
  EXPECT_LT(fine.largest, coarse.largest / 4.0);
  EXPECT_LT(fine.mean, coarse.mean / 16.0); // the triangles' own come nearer by 4
}

TEST(SurfaceNormals, AreOneOnTrianglesInTheMeanAndOfOneLength)
{
  // so what turns on a shaken sphere or cylinder slips freely, too: n . (omega x x) = 0 on every triangle
  for (const Map& map : {Map(onSphere), Map(onCylinder)}) {
    const TriangleSurface surface = grid(6, 6, map, 0.25);
    const auto normals = turningNormals(surface, 35.0);
    const double length = std::sqrt(dot(normals[0][0], normals[0][0]));
    double mean = 0.0;
    for (std::size_t t = 0; t < normals.size(); ++t)
      for (const Vector3& n : normals[t]) {
        EXPECT_NEAR(std::sqrt(dot(n, n)), length, 1e-13);
        EXPECT_NEAR(dot(n, surface.normals[t]), 1.0, 0.05);
        mean += dot(n, surface.normals[t]) / double(3 * normals.size());
      }
    EXPECT_NEAR(mean, 1.0, 1e-12);
  }
}

TEST(SurfaceNormals, TurnedAroundTheyAreTheOpposite)
{
  TriangleSurface surface = grid(5, 4, onSphere, 0.25);
  const auto normals = turningNormals(surface, 35.0);
  for (Vector3& n : surface.normals)
    for (double& component : n)
      component = -component;
  const auto opposite = turningNormals(surface, 35.0);
  ASSERT_EQ(opposite.size(), normals.size());
  for (std::size_t t = 0; t < normals.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(opposite[t][i][k], -normals[t][i][k], 1e-12);
}

TEST(SurfaceNormals, FlatPartsKeepTheirsAndEdgesTakeOneForEachSide)
{
  const auto roof = [](double slope) {
    return [=](double r, double q) { return Vector3{r, q, slope * std::max(0.0, r - 0.5)}; };
  };
  EXPECT_TRUE(turningNormals(grid(4, 3, roof(0.0)), 35.0).empty());
  EXPECT_TRUE(turningNormals(grid(4, 3, roof(1.0)), 35.0).empty()) << "a corner of 45 degrees";
  EXPECT_TRUE(turningNormals(grid(4, 3, roof(0.3)), 0.0).empty());
  const TriangleSurface bent = grid(6, 3, roof(0.3));
  const auto normals = turningNormals(bent, 35.0);
  ASSERT_EQ(normals.size(), bent.triangles.size());
  bool some = false;
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const auto& own = bent.triangles[t];
    const bool touchesBend = std::any_of(own.begin(), own.end(),
                                         [&](int v) { return std::abs(bent.points[std::size_t(v)][0] - 0.5) < 1e-9; });
    EXPECT_EQ(dot(normals[t][0], normals[t][0]) > 0.0, touchesBend) << t;
    for (std::size_t i = 0; i < 3 && touchesBend; ++i) {
      const bool isOnBend = std::abs(bent.points[std::size_t(own[i])][0] - 0.5) < 1e-9;
      const double apart = std::sqrt(std::pow(normals[t][i][0] - bent.normals[t][0], 2) +
                                     std::pow(normals[t][i][2] - bent.normals[t][2], 2));
      EXPECT_EQ(apart > 0.01, isOnBend);
      some = some || isOnBend;
    }
  }
  EXPECT_TRUE(some);
}

TEST(SurfaceNormals, APeakKeepsTheTrianglesNormals)
{
  TriangleSurface cone; // 24 sides, 10 degrees around its axis: each edge turns by little, all together by 340
  cone.points.push_back({0.0, 0.0, 0.0});
  const int sides = 24;
  const double slope = std::acos(-1.0) / 18.0, pi = std::acos(-1.0);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * pi * i / sides, middle = angle + pi / sides;
    cone.points.push_back({std::sin(slope) * std::cos(angle), std::sin(slope) * std::sin(angle), -std::cos(slope)});
    cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
    cone.normals.push_back({std::cos(middle) * 0.98496, std::sin(middle) * 0.98496, 0.17279});
  }
  const auto normals = turningNormals(cone, 35.0);
  ASSERT_EQ(normals.size(), cone.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    EXPECT_EQ(normals[t][0], cone.normals[t]);
    for (const std::size_t i : {1u, 2u})
      EXPECT_GT(dot(normals[t][i], cone.normals[t]), 0.95);
  }
}
