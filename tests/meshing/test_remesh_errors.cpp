#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "meshing/remesh_scenes.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The unit square; the side "down" has a corner at its middle.
const std::string square = R"(
Point(1) = {0, 0, 0, 0.5}; Point(2) = {0.5, 0, 0, 0.5}; Point(3) = {1, 0, 0, 0.5};
Point(4) = {1, 1, 0, 0.5}; Point(5) = {0, 1, 0, 0.5};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5}; Plane Surface(1) = {1}; Physical Curve("down") = {1, 2};
)";

/// The square below; its side "up" has no corner there.
const std::string below = R"(
Point(1) = {0, 0, 0, 0.5}; Point(2) = {1, 0, 0, 0.5}; Point(3) = {1, -1, 0, 0.5}; Point(4) = {0, -1, 0, 0.5};
Line(1) = {2, 1}; Line(2) = {3, 2}; Line(3) = {4, 3}; Line(4) = {1, 4};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Physical Curve("up") = {1};
)";

double third(double, double)
{
  return 1.0 / 3.0;
}

TEST(RemeshErrors, CornersOfMatchingSidesMustBeOnBoth)
{
  const ScriptScene scene = sceneOf(
      {scriptOf(scratchFile("below.geo", below)), scriptOf(scratchFile("square.geo", square))}, {{0, "up", 1, "down"}});
  EXPECT_THAT([&] { remeshed(scene, third); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("test.xml:4: Mesh: "), HasSubstr("square.geo: "),
                                              HasSubstr("side \"down\" has a corner at (0.5, 0)"))));
}

TEST(RemeshErrors, MatchingSidesAreNoClosedCurves)
{
  const std::string start = "SetFactory(\"OpenCASCADE\"); Mesh.MeshSizeMax = 0.3;\n";
  const std::string rim = "Physical Curve(\"rim\") = Curve In BoundingBox {0.2, 0.2, -1, 0.8, 0.8, 1};\n";
  const std::string pin = start + "Disk(1) = {0.5, 0.5, 0, 0.2};\n" + rim;
  const std::string plate = start +
                            "Rectangle(1) = {0, 0, 0, 1, 1}; Disk(2) = {0.5, 0.5, 0, 0.2};\n"
                            "BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };\n" +
                            rim;
  const ScriptScene scene = sceneOf({scriptOf(scratchFile("pin.geo", pin)), scriptOf(scratchFile("plate.geo", plate))},
                                    {{0, "rim", 1, "rim"}});
  EXPECT_THAT([&] { remeshed(scene, third); },
              ThrowsMessage<InputError>(HasSubstr("plate.geo: side \"rim\" has a curve that ends where it begins")));
}

TEST(RemeshErrors, GmshsMessagesComeThrough)
{
  const std::string path = scratchFile("square.geo", square);
  const ScriptScene scene = sceneOf({scriptOf(path)});
  scratchFile("square.geo", "Line(1) = {1, 2};");
  EXPECT_THAT([&] { remeshed(scene, third); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("test.xml:4: Mesh: " + path), HasSubstr("gmsh cannot"))));
  std::filesystem::remove(path);
  EXPECT_THAT([&] { remeshed(scene, third); }, ThrowsMessage<InputError>(HasSubstr("test.xml:4: Mesh: " + path)));
}

TEST(RemeshErrors, ScriptsThatMakeSolidsNowAreRefused)
{
  const std::string path = scratchFile("square.geo", square);
  const ScriptScene scene = sceneOf({scriptOf(path)});
  scratchFile("square.geo", square + "Extrude {0, 0, 1} { Surface{1}; }");
  EXPECT_THAT([&] { remeshed(scene, third); },
              ThrowsMessage<InputError>(HasSubstr("the script makes solids now, and it made a plane mesh before.")));
}

TEST(RemeshErrors, TimeIsLimited)
{
  ScriptScene scene = sceneOf({scriptOf(scratchFile("square.geo", square))});
  scene.scripts[0].maximumSeconds = 1;
  EXPECT_THAT([&] { remeshed(scene, [](double, double) { return 1e-5; }); },
              ThrowsMessage<InputError>(HasSubstr("did not finish within 1 s")));
}

TEST(RemeshErrors, OnlyGmshScriptsCanBeMeshedAgain)
{
  const auto box =
      meshSource(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "2, 2"));
  const auto file = meshSource(text("Type", "Gmsh") + text("File", dataPath("square-4.1-ascii.msh")));
  EXPECT_THAT([&] { box->script(); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("test.xml:3: Mesh: "), HasSubstr("or refine by Bisection."))));
  EXPECT_THAT([&] { file->script(); }, ThrowsMessage<InputError>(HasSubstr("test.xml:4: Mesh: ")));
  EXPECT_EQ(meshSource(text("Type", "Gmsh") + text("File", dataPath("square.geo")))->script().file,
            dataPath("square.geo"));
}

} // namespace
