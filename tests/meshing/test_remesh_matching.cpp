#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/bisection_scenes.hpp"
#include "meshing/mesh_deck.hpp"
#include "meshing/remesh_scenes.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::IsEmpty;
using testing::SizeIs;

const std::string upper = R"(
Point(1) = {0, 0, 0, 0.25}; Point(2) = {1, 0, 0, 0.25}; Point(3) = {1, 0.7, 0, 0.25}; Point(4) = {0, 0.7, 0, 0.25};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Physical Curve("down") = {1}; Physical Curve("rest") = {2, 3, 4};
)";

/// Its upper side goes the other way and is part of a longer edge.
const std::string lower = R"(
Point(1) = {0, 0, 0, 0.25}; Point(2) = {1, 0, 0, 0.25}; Point(3) = {1.5, 0, 0, 0.25};
Point(4) = {1.5, -1, 0, 0.25}; Point(5) = {0, -1, 0, 0.25};
Line(7) = {2, 1}; Line(8) = {3, 2}; Line(9) = {4, 3}; Line(10) = {5, 4}; Line(11) = {1, 5};
Curve Loop(1) = {7, 8, 9, 10, 11}; Plane Surface(1) = {1}; Physical Curve("up") = {7};
)";

/// The ring between two circles about the origin, a quarter; `pieces` of the arc "arc", which is one of them.
std::string ring(double inner, double outer, double arc, int pieces)
{
  const std::string text = R"(
Point(1) = {0, 0, 0};
For i In {0 : n}
  Point(10 + i) = {b * Cos(Pi / 2 * i / n), b * Sin(Pi / 2 * i / n), 0, 0.4};
EndFor
For i In {1 : n}
  Circle(10 + i) = {9 + i, 1, 10 + i};
EndFor
Point(2) = {a, 0, 0, 0.4}; Point(3) = {0, a, 0, 0.4};
Circle(1) = {2, 1, 3}; Line(2) = {3, 10 + n}; Line(3) = {10, 2};
Curve Loop(1) = {1, 2, 3, -(10 + n) : -11}; Plane Surface(1) = {1};
Physical Curve("arc") = {11 : 10 + n}; Physical Curve("other arc") = {1};
)";
  const double other = arc == inner ? outer : inner;
  return "n = " + std::to_string(pieces) + "; a = " + std::to_string(other) + "; b = " + std::to_string(arc) + ";\n" +
         text;
}

/// The half plane above or below a wave, both as splines of their own direction.
std::string wave(bool above)
{
  const std::string points =
      "Point(1) = {0, 0, 0, 0.2}; Point(2) = {0.3, 0.1, 0, 0.2}; Point(3) = {0.6, -0.05, 0, 0.2};\n"
      "Point(4) = {1, 0.02, 0, 0.2};\n";
  return points +
         (above ? "Point(5) = {1, 1, 0, 0.2}; Point(6) = {0, 1, 0, 0.2}; Spline(1) = {1, 2, 3, 4};\n"
                : "Point(5) = {1, -1, 0, 0.2}; Point(6) = {0, -1, 0, 0.2}; Spline(1) = {4, 3, 2, 1};\n") +
         (above ? "Line(2) = {4, 5}; Line(3) = {5, 6}; Line(4) = {6, 1};\n"
                : "Line(2) = {1, 6}; Line(3) = {6, 5}; Line(4) = {5, 4};\n") +
         "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Physical Curve(\"wave\") = {1};\n";
}

ScriptScene two(const std::string& first, const std::string& second, const std::string& firstSide,
                const std::string& secondSide)
{
  return sceneOf({scriptOf(scratchFile("first.geo", first)), scriptOf(scratchFile("second.geo", second))},
                 {{0, firstSide, 1, secondSide}});
}

ScriptScene regions(const std::string& file, const std::string& first, const std::string& second)
{
  const std::string path = std::string(NDFRAME_DECK_MESHES) + "/" + file;
  return sceneOf({scriptOf(path, first), scriptOf(path, second)}, {{0, "contact", 1, "contact"}});
}

/// Different on both sides of the interface.
double uneven(double x, double y)
{
  return y > 0.1 ? 0.03 + 0.05 * x : 0.11 - 0.02 * x;
}

void expectMatch(const ScriptScene& scene)
{
  const std::vector<Mesh> meshes = remeshed(scene, uneven);
  for (const MatchingSides& sides : scene.matching) {
    const auto first = sidePoints(meshes[std::size_t(sides.first)], sides.firstSide);
    EXPECT_EQ(first, sidePoints(meshes[std::size_t(sides.second)], sides.secondSide));
    EXPECT_GT(first.size(), 8u);
  }
  for (const Mesh& mesh : meshes)
    EXPECT_THAT(checkMesh(mesh), IsEmpty());
}

TEST(RemeshMatching, StraightSidesOfTwoScripts)
{
  expectMatch(two(upper, lower, "down", "up"));
  expectMatch(two(lower, upper, "up", "down"));
}

TEST(RemeshMatching, StraightSidesOfOneScript)
{
  expectMatch(regions("punch-foundation.geo", "punch", "foundation"));
}

TEST(RemeshMatching, CurvedSidesOfOneScript)
{
  expectMatch(regions("rings.geo", "inner", "outer"));
}

TEST(RemeshMatching, CurvedSidesOfTwoScripts)
{
  expectMatch(two(ring(2, 3, 2, 1), ring(1, 2, 2, 1), "arc", "arc"));
  expectMatch(two(ring(1, 2, 2, 3), ring(2, 3, 2, 1), "arc", "arc")); // corners of the first are vertices of the second
}

TEST(RemeshMatching, SplinesOfTwoScripts)
{
  expectMatch(two(wave(true), wave(false), "wave", "wave"));
  expectMatch(two(wave(false), wave(true), "wave", "wave"));
}

TEST(RemeshMatching, HoldsAgainAndAgain)
{
  ScriptScene scene = two(ring(2, 3, 2, 1), ring(1, 2, 2, 1), "arc", "arc");
  for (const double fine : {0.05, 0.01, 0.002}) {
    scene.meshes = remeshed(scene, [&](double x, double y) { return std::max(fine, 0.3 * std::hypot(x - 2, y)); });
    EXPECT_EQ(sidePoints(scene.meshes[0], "arc"), sidePoints(scene.meshes[1], "arc"));
  }
  for (const auto& point : sidePoints(scene.meshes[1], "arc"))
    EXPECT_NEAR(std::hypot(point[0], point[1]), 2.0, 1e-10);
}

TEST(RemeshMatching, CornersWithFewerDigitsAreTakenOver)
{
  std::string rounded = lower;
  for (std::size_t at; (at = rounded.find("{1, 0, 0,")) != std::string::npos;)
    rounded.replace(at, 9, "{1.0000001, 0.0000002, 0,");
  expectMatch(two(upper, rounded, "down", "up"));
}

TEST(RemeshMatching, TheShorterLengthCounts)
{
  const ScriptScene scene = two(upper, lower, "down", "up");
  for (const auto& [above, below] : {std::pair(0.02, 0.2), std::pair(0.2, 0.02)}) {
    const std::vector<Mesh> meshes =
        remesh(scene.scripts, scene.matching,
               {{scene.meshes[0], std::vector<double>(std::size_t(scene.meshes[0].numPoints()), above)},
                {scene.meshes[1], std::vector<double>(std::size_t(scene.meshes[1].numPoints()), below)}});
    EXPECT_NEAR(double(meshes[0].findSide("down")->facets.size()), 50.0, 2.0);
    EXPECT_NEAR(double(meshes[1].findSide("up")->facets.size()), 50.0, 2.0);
  }
}

TEST(MatchingSides, HaveTwinsEverywhere)
{
  const ScriptScene scene = two(upper, lower, "down", "up");
  const std::vector<MatchingSides> found = matchingSides(scene.meshes, findTwins(scene.meshes));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].firstSide, "down");
  EXPECT_EQ(found[0].second, 1);
  EXPECT_EQ(found[0].secondSide, "up");
  EXPECT_THAT(matchingSides(scene.meshes, {}), IsEmpty());
}

} // namespace
