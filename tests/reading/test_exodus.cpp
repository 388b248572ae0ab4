#include <exodusII.h>
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

std::string exodus(const ExodusSample& sample, const std::string& more = {}, int formatFlag = 0)
{
  const std::string path = scratchPath("mesh.e");
  writeExodus(path, sample, formatFlag);
  return text("Type", "Exodus") + text("File", path) + more;
}

Mesh flatBox()
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "2, 1") + ints("Cells", "3, 2"));
}

Mesh solidBox()
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0, 0") + doubles("Upper", "2, 1, 1") +
                  ints("Cells", "3, 2, 2"));
}

/// Two triangles in two blocks; the second block's mid-side nodes are those of a TRI6.
ExodusSample twoBlocks()
{
  ExodusSample sample;
  sample.points = {0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5, 0.5, 1, 0, 0.5};
  sample.blocks = {{10, "lower", "TRI3", 3, {1, 2, 3}}, {20, "", "tri6", 6, {1, 3, 4, 5, 6, 7}}};
  sample.sideSets = {{3, "", {1, 2}, {1, 2}}};
  return sample;
}

TEST(Exodus, ReadsBackEveryFormatOfTheLibrary)
{
  for (const Mesh& mesh : {flatBox(), solidBox()})
    for (const int format : {EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_NETCDF4})
      expectSameMesh(readMesh(exodus(asExodusSample(mesh), "", format)), mesh);
}

TEST(Exodus, ReadsFilesOf64BitData)
{
  const Mesh mesh = readMesh(text("Type", "Exodus") + text("File", dataPath("square-cdf5.e")));
  expectSameMesh(mesh, readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") +
                                ints("Cells", "2, 2")));
}

TEST(Exodus, MixesOrdersAndNamesUnnamedSets)
{
  const Mesh mesh = readMesh(exodus(twoBlocks()));
  EXPECT_EQ(mesh.cells, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.numPoints(), 4);
  ASSERT_NE(mesh.findSide("sideset_3"), nullptr);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("sideset_3")), 2.0, 1e-15); // bottom and top
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(Exodus, BlocksAreGroupsOfCells)
{
  const Mesh mesh = readMesh(exodus(twoBlocks()));
  ASSERT_EQ(mesh.groups.kind.size(), 2U);
  EXPECT_THAT(mesh.groups.names[std::size_t(mesh.groups.kind[0])], ElementsAre("lower"));
  EXPECT_THAT(mesh.groups.names[std::size_t(mesh.groups.kind[1])], ElementsAre("block_20"));
}

TEST(Exodus, ChoosesBlocksByNameOrNumber)
{
  EXPECT_EQ(readMesh(exodus(twoBlocks(), strings("Blocks", "lower"))).points, (std::vector<double>{0, 0, 1, 0, 1, 1}));
  const Mesh upper = readMesh(exodus(twoBlocks(), strings("Blocks", "20")));
  EXPECT_EQ(upper.points, (std::vector<double>{0, 0, 1, 1, 0, 1}));
  EXPECT_NEAR(measure(upper, upper.sides[0]), 1.0, 1e-15);
}

TEST(Exodus, StraightensCurvedEdgesAndSaysSo)
{
  ExodusSample sample = twoBlocks();
  sample.points[11] = 1.25;
  EXPECT_THAT(readMesh(exodus(sample)).notes,
              ElementsAre("1 curved edges have been straightened; their middle nodes moved by up to 0.25."));
}

TEST(Exodus, ReadsTetrahedraOfSecondOrder)
{
  ExodusSample sample;
  sample.dim = 3;
  sample.points = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  sample.blocks = {{1, "", "TETRA10", 10, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}};
  const Mesh mesh = readMesh(exodus(sample));
  EXPECT_EQ(mesh.cells, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_THAT(mesh.notes, IsEmpty()); // no edge is curved, so the middle nodes stand in the right order
}

TEST(Exodus, ReadsTrianglesInSpaceIfTheyLieInAPlane)
{
  ExodusSample sample;
  sample.dim = 3;
  sample.points = {0, 0, 5, 1, 0, 5, 0, 1, 5};
  sample.blocks = {{1, "", "TRI3", 3, {1, 2, 3}}};
  sample.sideSets = {{1, "bottom", {1}, {3}}};
  const Mesh mesh = readMesh(exodus(sample));
  EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(mesh.findSide("bottom")->facets[0].local, 2);
  sample.points[2] = 6;
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("do not lie in a plane z = constant (z goes from 5 to 6)."));
}

TEST(Exodus, LeavesOutBlocksOfLowerDimension)
{
  ExodusSample sample = twoBlocks();
  sample.blocks.push_back({30, "", "BAR2", 2, {1, 2}});
  EXPECT_EQ(readMesh(exodus(sample)).numCells(), 2);
}

TEST(Exodus, SaysWhichSideSetsAreEmpty)
{
  ExodusSample sample = twoBlocks();
  sample.sideSets.push_back({4, "nothing", {}, {}});
  EXPECT_THAT(readMesh(exodus(sample)).notes, ElementsAre("The side set nothing is empty and is left out."));
}

TEST(Exodus, TurnsNegativeElementsAround)
{
  ExodusSample sample = twoBlocks();
  sample.blocks.pop_back();
  sample.blocks[0].nodes = {2, 1, 3};
  sample.sideSets = {{1, "right", {1}, {3}}};
  const Mesh mesh = readMesh(exodus(sample));
  EXPECT_NEAR(volume(mesh), 0.5, 1e-15);
  double n[2];
  EXPECT_NEAR(facetNormal(mesh, mesh.sides[0].facets[0], n), 1.0, 1e-15);
  EXPECT_NEAR(n[0], 1.0, 1e-15);
}

TEST(Exodus, RefusesOtherElements)
{
  ExodusSample sample = twoBlocks();
  sample.blocks.push_back({30, "brick", "QUAD5", 5, {1, 2, 3, 4, 5}});
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("the elements of block brick are of type QUAD5 with 5 nodes"));
  EXPECT_EQ(readMesh(exodus(sample, strings("Blocks", "lower, 20"))).numCells(), 2);
}

TEST(Exodus, RefusesInvertedElements)
{
  ExodusSample sample = twoBlocks();
  sample.blocks[1].nodes = {3, 1, 4, 5, 7, 6};
  EXPECT_THAT(messageOf(exodus(sample)),
              HasSubstr("1 of 2 elements are inverted; the first is element 2 at (0.333333, 0.666667)."));
}

TEST(Exodus, RefusesNodesSidesAndElementsThatDoNotExist)
{
  ExodusSample sample = twoBlocks();
  sample.blocks[0].nodes[2] = 99;
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("an element uses node 99, but there are 7 nodes."));
  sample = twoBlocks();
  sample.sideSets[0].sides[0] = 4;
  EXPECT_THAT(messageOf(exodus(sample)),
              HasSubstr("side set sideset_3 names side 4 of element 1, which does not exist."));
  sample.sideSets[0].elements[0] = 3;
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("side set sideset_3 names element 3, but there are 2."));
}

TEST(Exodus, RefusesSidesInside)
{
  ExodusSample sample = twoBlocks();
  sample.sideSets[0].sides[0] = 3;
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("1 facets of side \"sideset_3\" are not on the boundary"));
}

TEST(Exodus, RefusesAMeshWithoutCells)
{
  ExodusSample sample;
  sample.points = {0, 0, 1, 0};
  sample.blocks = {{30, "", "BAR2", 2, {1, 2}}};
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("the mesh has no triangles and no tetrahedra."));
}

TEST(Exodus, RefusesOtherFiles)
{
  const auto file = [](const std::string& path) { return text("Type", "Exodus") + text("File", path); };
  EXPECT_THAT(messageOf(file("/nowhere/mesh.e")),
              HasSubstr("/nowhere/mesh.e: the file cannot be read; relative paths start from the deck's folder."));
  EXPECT_THAT(messageOf(file(testing::TempDir())), HasSubstr("this is a directory, not a file."));
  EXPECT_THAT(messageOf(file(scratchFile("empty.e", ""))),
              HasSubstr("the file is not netCDF, so it is not an Exodus file."));
  EXPECT_THAT(messageOf(file(dataPath("square.geo"))), HasSubstr("the file is not netCDF"));
}

} // namespace
