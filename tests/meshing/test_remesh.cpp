#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "meshing/remesh_scenes.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::Contains;
using testing::ElementsAre;

const double pi = std::acos(-1.0);

/// A plate [0, 2] x [0, 1] with a round hole, in triangles of size 0.3.
const std::string plate = R"(
If (!Exists(u)) u = 1; EndIf
r = 0.25*u;
Point(1) = {0, 0, 0, 0.3*u}; Point(2) = {2*u, 0, 0, 0.3*u}; Point(3) = {2*u, u, 0, 0.3*u}; Point(4) = {0, u, 0, 0.3*u};
Point(5) = {0.7*u, 0.55*u, 0, 0.3*u};
Point(6) = {0.7*u + r, 0.55*u, 0, 0.3*u}; Point(7) = {0.7*u, 0.55*u + r, 0, 0.3*u};
Point(8) = {0.7*u - r, 0.55*u, 0, 0.3*u}; Point(9) = {0.7*u, 0.55*u - r, 0, 0.3*u};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Circle(5) = {6, 5, 7}; Circle(6) = {7, 5, 8}; Circle(7) = {8, 5, 9}; Circle(8) = {9, 5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(1) = {1, 2};
Physical Curve("below") = {1}; Physical Curve("ends") = {2, 4}; Physical Curve("hole") = {5, 6, 7, 8};
Physical Surface("plate") = {1};
)";

ScriptScene sceneFrom(const std::string& script)
{
  return sceneOf({scriptOf(scratchFile("scene.geo", script))});
}

/// Lengths of edges by the wanted ones at their middles.
template <class Length>
std::vector<double> ratios(const Mesh& mesh, const Length& length)
{
  std::vector<double> found;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int k = 0; k < 3; ++k) {
      const double *a = mesh.point(mesh.cell(c)[k]), *b = mesh.point(mesh.cell(c)[(k + 1) % 3]);
      found.push_back(std::hypot(a[0] - b[0], a[1] - b[1]) / length((a[0] + b[0]) / 2, (a[1] + b[1]) / 2));
    }
  std::sort(found.begin(), found.end());
  return found;
}

template <class Length>
void expectLengths(const Mesh& mesh, const Length& length)
{
  const std::vector<double> found = ratios(mesh, length);
  const double median = found[found.size() / 2];
  EXPECT_GT(median, 0.8);
  EXPECT_LT(median, 1.15);
  EXPECT_GT(found.front(), 0.4);
  EXPECT_LT(found.back(), 1.8);
}

TEST(Remesh, EdgesHaveTheWantedLengths)
{
  const ScriptScene scene = sceneFrom(plate);
  for (const double h : {0.15, 0.04}) {
    const auto length = [&](double, double) { return h; };
    expectLengths(remeshed(scene, length)[0], length);
  }
}

TEST(Remesh, LengthsMayDifferAThousandfold)
{
  ScriptScene scene = sceneFrom(plate);
  const auto length = [](double x, double y) { return std::max(3e-4, 0.15 * std::hypot(x - 2.0, y)); };
  // A coarse mesh cannot hold this function: the next ones hold it better.
  for (int i = 0; i < 4; ++i)
    scene.meshes = remeshed(scene, length);
  expectLengths(scene.meshes[0], length);
  const std::vector<double> lengths = ratios(scene.meshes[0], [](double, double) { return 1.0; });
  EXPECT_LT(lengths.front(), 4e-4);
  EXPECT_GT(lengths.back(), 0.2);
}

TEST(Remesh, BoundariesAreThoseOfTheGeometry)
{
  const ScriptScene scene = sceneFrom(plate);
  double before = 1.0;
  for (const double h : {0.1, 0.05, 0.025}) {
    const Mesh mesh = remeshed(scene, [&](double, double) { return h; })[0];
    for (const auto& point : sidePoints(mesh, "hole"))
      EXPECT_NEAR(std::hypot(point[0] - 0.7, point[1] - 0.55), 0.25, 1e-10);
    const double missing = volume(mesh) - (2.0 - pi * 0.25 * 0.25);
    EXPECT_LT(missing, 0.4 * before);
    before = missing;
    EXPECT_NEAR(measure(mesh, *mesh.findSide("below")), 2.0, 1e-12);
    EXPECT_NEAR(measure(mesh, *mesh.findSide("ends")), 2.0, 1e-12);
    EXPECT_LT(boundaryDefect(mesh), 1e-12);
  }
}

TEST(Remesh, KeepsSidesAndCorners)
{
  const ScriptScene scene = sceneFrom(plate);
  const Mesh mesh = remeshed(scene, [](double, double) { return 0.5; })[0];
  std::vector<std::string> names;
  for (const Side& side : mesh.sides)
    names.push_back(side.name);
  EXPECT_THAT(names, ElementsAre("below", "ends", "hole"));
  for (const auto& corner : {std::vector<double>{0, 0}, {2, 0}, {2, 1}, {0, 1}})
    EXPECT_THAT(sidePoints(mesh, "ends"), Contains(corner));
}

TEST(Remesh, KeepsPointsInsideARegion)
{
  const std::string path = scratchFile("scene.geo", plate + R"(
Point(20) = {1.5, 0.5, 0, 0.3}; Point{20} In Surface{1};
Point(21) = {3, 0, 0, 0.3}; Line(20) = {2, 21}; Line(21) = {21, 3};
Curve Loop(3) = {20, 21, -2}; Plane Surface(2) = {3}; Physical Surface("other") = {2};
)");
  const Mesh mesh = remeshed(sceneOf({scriptOf(path, "plate")}), [](double, double) { return 0.2; })[0];
  bool found = false;
  for (int v = 0; v < mesh.numPoints(); ++v)
    found = found || (mesh.point(v)[0] == 1.5 && mesh.point(v)[1] == 0.5);
  EXPECT_TRUE(found);
  EXPECT_NEAR(volume(mesh), 1.8, 0.03);
}

TEST(Remesh, IsTheSameEveryTime)
{
  const ScriptScene scene = sceneFrom(plate);
  const auto length = [](double x, double y) { return 0.02 + 0.1 * x * y; };
  expectSameMesh(remeshed(scene, length)[0], remeshed(scene, length)[0]);
}

TEST(Remesh, DoesNotDependOnUnits)
{
  const Mesh plain = remeshed(sceneFrom(plate), [](double, double) { return 0.05; })[0];
  for (const double unit : {1e-4, 1e5}) {
    const Mesh mesh =
        remeshed(sceneFrom(fmt::format("u = {};", unit) + plate), [&](double, double) { return 0.05 * unit; })[0];
    EXPECT_NEAR(mesh.numCells(), plain.numCells(), 0.05 * plain.numCells());
    EXPECT_NEAR(volume(mesh) / (unit * unit), volume(plain), 1e-12);
  }
}

TEST(Remesh, SizesOfTheScriptGiveWay)
{
  const auto length = [](double, double) { return 0.1; };
  const int plain = remeshed(sceneFrom(plate), length)[0].numCells();
  for (const char* own :
       {"Mesh.MeshSizeFactor = 0.3; Mesh.MeshSizeMax = 0.05; Mesh.MeshSizeMin = 0.04; Mesh.MeshSizeFromCurvature = 90;",
        "Field[1] = MathEval; Field[1].F = \"0.05\"; Background Field = 1; Mesh.ElementOrder = 2; Mesh.Algorithm = 5;",
        "MeshSize {1, 2} = 0.02; Mesh 2;"})
  {
    SCOPED_TRACE(own);
    EXPECT_NEAR(remeshed(sceneFrom(plate + own + "\n"), length)[0].numCells(), plain, 0.03 * plain);
  }
}

} // namespace
