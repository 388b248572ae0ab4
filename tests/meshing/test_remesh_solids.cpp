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
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

using Length = double (*)(double, double, double);

/// A cylinder of radius 0.5 and height 1 on the block [-1, 1] x [-1, 1] x [-1, 0]; more: what the script also says.
std::string cylinderOnBlock(const std::string& join, const std::string& more = {})
{
  return R"(
SetFactory("OpenCASCADE");
If (!Exists(u)) u = 1; EndIf
Mesh.MeshSizeMax = 0.5*u;
Box(1) = {-u, -u, -u, 2*u, 2*u, u};
Cylinder(2) = {0, 0, 0, 0, 0, u, 0.5*u};
)" + join +
         R"(
Physical Volume("block") = {1}; Physical Volume("cylinder") = {2};
e = 1e-4*u;
Physical Surface("disc") = Surface In BoundingBox {-0.5*u - e, -0.5*u - e, -e, 0.5*u + e, 0.5*u + e, e};
all() = Boundary{ Volume{2}; };
Physical Surface("skin") = {all()};
)" + more;
}

const char* const fragments = "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n";

ScriptScene scene(const std::string& script)
{
  const std::string path = scratchFile("solids.geo", script);
  return sceneOf({scriptOf(path, "block"), scriptOf(path, "cylinder")}, {{0, "disc", 1, "disc"}});
}

std::vector<Mesh> meshed(const ScriptScene& scene, Length length)
{
  std::vector<WantedMesh> wanted;
  for (const Mesh& mesh : scene.meshes) {
    wanted.push_back({mesh, {}});
    for (int v = 0; v < mesh.numPoints(); ++v)
      wanted.back().lengths.push_back(length(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]));
  }
  return remesh(scene.scripts, scene.matching, wanted);
}

double tenth(double, double, double)
{
  return 0.15;
}

/// Small at the rim of the disc.
double atRim(double x, double y, double z)
{
  return 0.04 + 0.35 * std::hypot(std::hypot(x, y) - 0.5, z);
}

/// log2 of measures by those of regular tetrahedra with the lengths at their centres.
std::vector<double> ratios(const Mesh& mesh, Length length)
{
  std::vector<double> found;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const std::array<double, 3> x = cellCentre(mesh, c);
    found.push_back(std::log2(cellMeasure(mesh, c) * std::sqrt(72.0) / std::pow(length(x[0], x[1], x[2]), 3)));
  }
  return found;
}

double mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum / double(values.size());
}

TEST(RemeshSolids, CellsHaveTheWantedMeasures)
{
  ScriptScene solids = scene(cylinderOnBlock(fragments));
  for (const Length length : {Length(tenth), Length(atRim)}) {
    solids.meshes = meshed(solids, length);
    solids.meshes = meshed(solids, length); // the first mesh did not hold the function
    for (const Mesh& mesh : solids.meshes) {
      EXPECT_THAT(checkMesh(mesh), IsEmpty());
      EXPECT_NEAR(mean(ratios(mesh, length)), 0.0, 0.35);
    }
  }
}

/// Not small cells at the rim and large ones elsewhere, as gmsh makes them from sizes alone (1.1 apart).
TEST(RemeshSolids, NoPlaceIsPreferred)
{
  ScriptScene solids = scene(cylinderOnBlock(fragments));
  for (int i = 0; i < 2; ++i)
    solids.meshes = meshed(solids, atRim);
  const Mesh& block = solids.meshes[0];
  const std::vector<double> all = ratios(block, atRim);
  std::vector<double> near, far;
  for (int c = 0; c < block.numCells(); ++c) {
    const std::array<double, 3> x = cellCentre(block, c);
    (std::hypot(std::hypot(x[0], x[1]) - 0.5, x[2]) < 0.2 ? near : far).push_back(all[std::size_t(c)]);
  }
  EXPECT_GT(near.size(), 500U);
  EXPECT_GT(far.size(), 100U);
  EXPECT_NEAR(mean(near), mean(far), 0.6);
}

TEST(RemeshSolids, CommonFacesHaveTheSameTriangles)
{
  const ScriptScene solids = scene(cylinderOnBlock(fragments));
  const std::vector<Mesh> meshes = meshed(solids, atRim);
  const std::size_t facets = meshes[0].findSide("disc")->facets.size();
  EXPECT_GT(facets, 100U);
  EXPECT_THAT(commonFacets(meshes), SizeIs(facets));
  EXPECT_THAT(meshes[1].findSide("disc")->facets, SizeIs(facets));
  const std::vector<MatchingSides> matching = matchingSides(meshes, commonFacets(meshes));
  ASSERT_THAT(matching, SizeIs(1));
  EXPECT_EQ(matching[0].firstSide, "disc");
  EXPECT_EQ(matching[0].secondSide, "disc");
}

TEST(RemeshSolids, TheShorterLengthCountsOnACommonFace)
{
  const ScriptScene solids = scene(cylinderOnBlock(fragments));
  std::vector<std::size_t> facets;
  for (const auto& [above, below] : {std::pair(0.08, 0.3), std::pair(0.3, 0.08)}) {
    const std::vector<Mesh>& first = solids.meshes;
    const std::vector<Mesh> meshes =
        remesh(solids.scripts, solids.matching,
               {{first[0], std::vector<double>(std::size_t(first[0].numPoints()), below)},
                {first[1], std::vector<double>(std::size_t(first[1].numPoints()), above)}});
    facets.push_back(meshes[0].findSide("disc")->facets.size());
  }
  const double wanted = std::acos(-1.0) * 0.25 / (std::sqrt(3.0) / 4 * 0.08 * 0.08);
  for (const std::size_t found : facets)
    EXPECT_NEAR(double(found), wanted, 0.4 * wanted);
}

TEST(RemeshSolids, BoundariesAreThoseOfTheGeometry)
{
  const Mesh cylinder = meshed(scene(cylinderOnBlock(fragments)), tenth)[1];
  const double missing = std::acos(-1.0) * 0.25 - volume(cylinder);
  EXPECT_GT(missing, 0.0); // chords
  EXPECT_LT(missing, 0.015);
  for (const Facet facet : cylinder.findSide("skin")->facets) {
    int v[3];
    facetVertices(cylinder, facet, v);
    for (const int vertex : v) {
      const double* x = cylinder.point(vertex);
      const bool isOnEnd = std::abs(x[2]) < 1e-12 || std::abs(x[2] - 1.0) < 1e-12;
      EXPECT_LT(std::hypot(x[0], x[1]), 0.5 + 1e-10);
      EXPECT_TRUE(isOnEnd || std::abs(std::hypot(x[0], x[1]) - 0.5) < 1e-10);
    }
  }
  EXPECT_LT(boundaryDefect(cylinder), 1e-12);
}

TEST(RemeshSolids, AreTheSameEveryTime)
{
  const ScriptScene solids = scene(cylinderOnBlock(fragments));
  const std::vector<Mesh> once = meshed(solids, atRim), again = meshed(solids, atRim);
  for (std::size_t b = 0; b < 2; ++b)
    expectSameMesh(once[b], again[b]);
}

TEST(RemeshSolids, WhatTheScriptSaysOfMeshesGivesWay)
{
  const int plain = meshed(scene(cylinderOnBlock(fragments)), tenth)[0].numCells();
  for (const char* own :
       {"Mesh.MeshSizeFactor = 0.7; Mesh.MeshSizeFromCurvature = 30; Mesh.ElementOrder = 2;",
        "Mesh.Algorithm3D = 10; General.NumThreads = 2; Mesh.RandomFactor = 1e-4;",
        "Field[1] = MathEval; Field[1].F = \"0.3\"; Background Field = 1; Mesh 3;", "Transfinite Curve {:} = 5;"})
  {
    SCOPED_TRACE(own);
    EXPECT_NEAR(meshed(scene(cylinderOnBlock(fragments, std::string(own) + "\n")), tenth)[0].numCells(), plain,
                0.1 * plain);
  }
}

TEST(RemeshSolids, SidesThatOnlyLieOnEachOtherAreRefused)
{
  const ScriptScene solids = scene(cylinderOnBlock(fragments));
  scratchFile("solids.geo", cylinderOnBlock("")); // no common face any more
  EXPECT_THAT([&] { meshed(solids, tenth); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("solids.geo: "), HasSubstr("\"block\" and \"cylinder\" touch"),
                                              HasSubstr("BooleanFragments or Coherence"))));
}

TEST(RemeshSolids, ScriptsThatBecamePlaneAreRefused)
{
  const ScriptScene solids = scene(cylinderOnBlock(fragments));
  scratchFile("solids.geo", "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 1};\n");
  EXPECT_THAT([&] { meshed(solids, tenth); },
              ThrowsMessage<InputError>(HasSubstr("the script makes a plane mesh now, and it made solids before.")));
}

} // namespace
