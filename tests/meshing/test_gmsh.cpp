#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "reading/mesh_files.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string gmsh(const std::string& path, const std::string& more = {})
{
  return text("Type", "Gmsh") + text("File", path) + more;
}

Mesh fromText(const std::string& contents, const std::string& more = {})
{
  return readMesh(gmsh(scratchFile("mesh.msh", contents), more));
}

Mesh box(const std::string& more)
{
  return readMesh(text("Type", "Box") + more);
}

Mesh flatBox()
{
  return box(doubles("Lower", "0, 0") + doubles("Upper", "2, 1") + ints("Cells", "3, 2") + number("Rotation", "10"));
}

Mesh solidBox()
{
  return box(doubles("Lower", "0, 0, 0") + doubles("Upper", "2, 1, 1") + ints("Cells", "3, 2, 2"));
}

/// Does any loaded library have this name?
bool isLoaded(const std::string& library)
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.find(library) != std::string::npos)
      return true;
  return false;
}

const char* const header22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const char* const squareNodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";

TEST(Gmsh, ReadsBackAsciiFilesOfBothFormats)
{
  for (const Mesh& mesh : {flatBox(), solidBox()}) {
    expectSameMesh(fromText(asMsh22(mesh)), mesh);
    expectSameMesh(fromText(asMsh41(mesh)), mesh);
  }
}

TEST(Gmsh, AcceptsWindowsLineEnds)
{
  std::string contents;
  for (const char c : asMsh41(flatBox()))
    contents += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expectSameMesh(fromText(contents), flatBox());
}

TEST(Gmsh, ReadsTheFourKindsOfFilesThatGmshWritesAlike)
{
  const Mesh mesh = readMesh(gmsh(dataPath("square-4.1-ascii.msh")));
  EXPECT_NEAR(volume(mesh), 1.0, 1e-14);
  EXPECT_LT(boundaryDefect(mesh), 1e-14);
  for (const char* side : {"bottom", "right", "top", "left"})
    EXPECT_NEAR(measure(mesh, *mesh.findSide(side)), 1.0, 1e-14) << side;
  EXPECT_NEAR(measure(mesh, *mesh.findSide("rim")), 4.0, 1e-14);
  for (const char* file : {"square-4.1-binary.msh", "square-2.2-ascii.msh", "square-2.2-binary.msh"})
    expectSameMesh(readMesh(gmsh(dataPath(file))), mesh, 1e-15); // ASCII files have 16 digits
}

TEST(Gmsh, ReadsSecondOrderTetrahedraByTheirVertices)
{
  for (const char* file : {"cube-4.1-binary.msh", "cube-2.2-binary.msh"}) {
    const Mesh mesh = readMesh(gmsh(dataPath(file)));
    EXPECT_EQ(mesh.dim, 3);
    EXPECT_NEAR(volume(mesh), 1.0, 1e-14);
    EXPECT_LT(boundaryDefect(mesh), 1e-14);
    const double z[] = {0, 0, 1};
    EXPECT_NEAR(measure(mesh, *mesh.findSide("top")), 1.0, 1e-14);
    EXPECT_EQ(distanceFromPlane(mesh, *mesh.findSide("top"), z, 1.0), 0.0);
    EXPECT_THAT(mesh.notes, IsEmpty());
  }
}

TEST(Gmsh, MeshesScriptsOnTheFly)
{
  const Mesh mesh = readMesh(gmsh(dataPath("square.geo")));
  EXPECT_NEAR(volume(mesh), 1.0, 1e-12);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("rim")), 4.0, 1e-12);
  const Mesh finer = readMesh(gmsh(dataPath("square.geo"), number("Mesh Size Factor", "0.5")));
  EXPECT_GT(finer.numCells(), 2 * mesh.numCells());
  const Mesh solid = readMesh(gmsh(dataPath("cube.geo")));
  EXPECT_NEAR(volume(solid), 1.0, 1e-12);
}

/// With HXT on two threads one run of twenty crashed, hung or asked for all memory, and no two meshes were the same.
TEST(Gmsh, ScriptsThatAskForHxtHaveTheSameMeshEveryTime)
{
  const std::string script =
      "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 1, 1, 1}; Cylinder(2) = {0.5, 0.5, 1, 0, 0, 1, 0.4};\n"
      "Coherence; Mesh.MeshSizeMax = 0.2; Mesh.RandomFactor = 1e-4;\n";
  const Mesh mesh = readMesh(gmsh(scratchFile("steady.geo", script)));
  for (int i = 0; i < 3; ++i)
    expectSameMesh(mesh, readMesh(gmsh(scratchFile("hxt.geo", script + "Mesh.Algorithm3D = 10; General.NumThreads = 2; "
                                                                       "Mesh.MaxNumThreads3D = 2;\n"))));
}

TEST(Gmsh, LibraryIsNeverLoadedIntoThisProcess)
{
  readMesh(gmsh(dataPath("square-4.1-binary.msh")));
  readMesh(gmsh(dataPath("square.geo"))); // in a child process
  EXPECT_FALSE(isLoaded("libgmsh"));
}

TEST(Gmsh, StraightensCurvedEdgesAndSaysSo)
{
  const Mesh mesh = readMesh(gmsh(dataPath("quarter-disc.geo")));
  const std::size_t arcEdges = mesh.findSide("arc")->facets.size();
  // Every chord spans the same angle; the middle of the arc is 1 - cos(angle / 2) off the chord.
  const double sagitta = 1.0 - std::cos(std::acos(-1.0) / 4 / double(arcEdges));
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_THAT(mesh.notes[0], HasSubstr(fmt::format("{} curved edges have been straightened", arcEdges)));
  EXPECT_THAT(mesh.notes[0], HasSubstr(fmt::format("moved by up to {:.3g}.", sagitta)));
}

TEST(Gmsh, TurnsNegativeElementsAround)
{
  Mesh mirrored = flatBox();
  for (int c = 0; c < mirrored.numCells(); ++c)
    std::swap(mirrored.cells[3 * c + 1], mirrored.cells[3 * c + 2]);
  for (Side& side : mirrored.sides)
    for (Facet& facet : side.facets)
      facet.local = facet.local == 0 ? 0 : 3 - facet.local;
  const Mesh mesh = fromText(asMsh22(mirrored));
  EXPECT_NEAR(volume(mesh), 2.0, 1e-14);
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("reoriented")));
  const Mesh straight = flatBox();
  for (const Side& side : straight.sides) {
    double expected[2];
    double n[2];
    facetNormal(straight, side.facets[0], expected);
    EXPECT_NEAR(measure(mesh, *mesh.findSide(side.name)), measure(straight, side), 1e-14);
    facetNormal(mesh, mesh.findSide(side.name)->facets[0], n);
    EXPECT_NEAR(n[0], expected[0], 1e-14);
    EXPECT_NEAR(n[1], expected[1], 1e-14);
  }
}

TEST(Gmsh, WhatIsRoundOffBesideTheSizeIsZero)
{
  const std::string cells = "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n";
  const std::string nodes = "$Nodes\n4\n1 6.1e-17 -3e-33 0\n2 1 1e-15 0\n3 1 1 0\n4 -9e-17 1 0\n$EndNodes\n";
  EXPECT_THAT(fromText(header22 + nodes + cells).points, ElementsAre(0, 0, 1, 1e-15, 1, 1, 0, 1));
  const std::string small =
      "$Nodes\n4\n1 6.1e-17 -3e-33 0\n2 1e-3 1e-15 0\n3 1e-3 1e-3 0\n4 -9e-17 1e-3 0\n$EndNodes\n";
  EXPECT_THAT(fromText(header22 + small + cells).points,
              ElementsAre(6.1e-17, 0, 1e-3, 1e-15, 1e-3, 1e-3, -9e-17, 1e-3));
}

TEST(Gmsh, DropsPointsThatNoCellUses)
{
  const Mesh mesh = fromText(std::string(header22) + squareNodes + "$Elements\n1\n1 2 2 0 1 1 2 4\n$EndElements\n");
  EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 1, 0, 0, 1}));
  EXPECT_TRUE(mesh.sides.empty());
}

TEST(Gmsh, TakesAllCellsWithoutPhysicalGroupsAndOnlyThoseInGroupsOtherwise)
{
  const std::string nodes = std::string(header22) + squareNodes;
  EXPECT_EQ(fromText(nodes + "$Elements\n2\n1 2 2 0 1 1 2 3\n2 2 2 0 1 1 3 4\n$EndElements\n").numCells(), 2);
  EXPECT_EQ(fromText(nodes + "$Elements\n2\n1 2 2 0 1 1 2 3\n2 2 2 5 1 1 3 4\n$EndElements\n").numCells(), 1);
}

TEST(Gmsh, CallsUnnamedGroupsByTheirTag)
{
  const Mesh mesh =
      fromText(std::string(header22) + squareNodes + "$Elements\n2\n1 1 2 17 1 1 2\n2 2 2 0 1 1 2 3\n$EndElements\n");
  EXPECT_NE(mesh.findSide("physical_17"), nullptr);
}

TEST(Gmsh, CellsRememberTheirGroups)
{
  const std::string nodes =
      std::string(header22) + "$PhysicalNames\n1\n2 5 \"core\"\n$EndPhysicalNames\n" + squareNodes;
  const auto groupsOf = [](const Mesh& mesh, int cell) {
    return mesh.groups.names[std::size_t(mesh.groups.kind[std::size_t(cell)])];
  };
  // Format 2.2 lists a cell once for each of its groups.
  const Mesh mesh = fromText(nodes + "$Elements\n3\n1 2 2 5 1 1 2 3\n2 2 2 7 1 1 3 4\n3 2 2 7 1 1 2 3\n$EndElements\n");
  ASSERT_EQ(mesh.numCells(), 2);
  EXPECT_THAT(groupsOf(mesh, 0), ElementsAre("core", "physical_7"));
  EXPECT_THAT(groupsOf(mesh, 1), ElementsAre("physical_7"));
  EXPECT_TRUE(fromText(nodes + "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n").groups.kind.empty());
  EXPECT_THAT(groupsOf(fromText(asMsh41(flatBox())), 3), ElementsAre("body"));
}

TEST(Gmsh, SaysWhichGroupsAreEmpty)
{
  const Mesh mesh = fromText(std::string(header22) + "$PhysicalNames\n1\n1 3 \"top\"\n$EndPhysicalNames\n" +
                             squareNodes + "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n");
  EXPECT_THAT(mesh.notes, ElementsAre("The physical group \"top\" has no elements and is left out."));
}

TEST(Gmsh, SkipsOtherSections)
{
  const std::string contents = asMsh22(flatBox());
  expectSameMesh(fromText(contents + "$NodeData\n1\n\"u\"\n0\n0\n$EndNodeData\n$Comments\n$EndComments\n"), flatBox());
}

} // namespace
