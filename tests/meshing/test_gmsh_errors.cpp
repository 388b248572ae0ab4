#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "gmsh_library.hpp"
#include "meshing/mesh_deck.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string gmsh(const std::string& path, const std::string& more = {})
{
  return text("Type", "Gmsh") + text("File", path) + more;
}

std::string messageFor(const std::string& contents, const std::string& more = {})
{
  return messageOf(gmsh(scratchFile("mesh.msh", contents), more));
}

/// A script: the unit square in triangles of size 1.
const std::string square = "Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Point(3) = {1, 1, 0, 1};\n"
                           "Point(4) = {0, 1, 0, 1}; Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4};\n"
                           "Line(4) = {4, 1}; Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};\n";

const std::string header = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";

std::string elements(int count, const std::string& lines)
{
  return "$Elements\n" + std::to_string(count) + "\n" + lines + "$EndElements\n";
}

TEST(GmshErrors, NameTheDeckTheListAndTheFile)
{
  EXPECT_THAT(
      messageOf(gmsh("nowhere.msh")),
      HasSubstr(
          "test.xml:4: Mesh: nowhere.msh: the file cannot be read; relative paths start from the deck's folder."));
  EXPECT_THAT(messageOf(gmsh(testing::TempDir())), HasSubstr("this is a directory, not a file."));
}

TEST(GmshErrors, FileMustBeMsh)
{
  EXPECT_THAT(messageFor(""), HasSubstr("the file is empty."));
  EXPECT_THAT(messageFor("solid cube\n"), HasSubstr("the file does not begin with $MeshFormat"));
}

TEST(GmshErrors, FormatMustBeKnown)
{
  EXPECT_THAT(messageFor("$MeshFormat\n3 0 8\n$EndMeshFormat\n"),
              HasSubstr("MSH format 3 is not read; save the mesh as 4.1 or 2.2."));
  EXPECT_THAT(messageFor("$MeshFormat\n2.2 0 4\n$EndMeshFormat\n"), HasSubstr("the data size 8."));
  const std::string swapped("$MeshFormat\n4.1 1 8\n\0\0\0\1\n$EndMeshFormat\n", 41);
  EXPECT_THAT(messageFor(swapped), HasSubstr("another byte order"));
}

TEST(GmshErrors, SectionsMustBeThereOnce)
{
  EXPECT_THAT(messageFor(header), HasSubstr("the file has no section $Nodes; it may have been cut off."));
  EXPECT_THAT(messageFor(header + nodes), HasSubstr("the file has no section $Elements"));
  EXPECT_THAT(messageFor(header + nodes + nodes), HasSubstr("line 12: a second section $Nodes."));
  EXPECT_THAT(messageFor(header + nodes + "$NodeData\n1 2 3\n"), HasSubstr("the section $NodeData has no end"));
  EXPECT_THAT(messageFor(header + nodes + "7 8 9\n"), HasSubstr("\"7 8 9\" is found where a section should begin."));
  EXPECT_THAT(messageFor("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PartitionedEntities\n"),
              HasSubstr("the mesh is partitioned"));
}

TEST(GmshErrors, CountsMustFit)
{
  EXPECT_THAT(messageFor(header + "$Nodes\n3\n1 0 0 0\n2 1 0 0\n$EndNodes\n"),
              HasSubstr("line 8: \"$EndNodes\" is not an integer."));
  EXPECT_THAT(messageFor(header + "$Nodes\n1\n1 0 0 0\n2 1 0 0\n$EndNodes\n"),
              HasSubstr("line 7: $EndNodes is expected here."));
  EXPECT_THAT(messageFor(header + "$Nodes\n1000000000000\n1 0 0 0\n$EndNodes\n"),
              HasSubstr("a count of 1000000000000 does not fit in the rest of the file."));
  EXPECT_THAT(messageFor(header + "$Nodes\n-1\n$EndNodes\n"), HasSubstr("a count of -1"));
}

TEST(GmshErrors, NodesMustExistOnce)
{
  EXPECT_THAT(messageFor(header + nodes + elements(1, "1 2 2 0 1 1 2 5\n")),
              HasSubstr("an element uses node 5, which does not exist."));
  EXPECT_THAT(messageFor(header + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n"), HasSubstr("node 1 is given twice."));
  EXPECT_THAT(messageFor(header + "$Nodes\n1\n1 0 nan 0\n$EndNodes\n"), HasSubstr("\"nan\" is not a finite number."));
}

TEST(GmshErrors, ElementsMustBeOfOrderOneOrTwo)
{
  EXPECT_THAT(messageFor(header + nodes + elements(1, "9 21 2 0 1 1 2 3 4 1 2 3 4 1 2\n")),
              HasSubstr("a triangle of order 3"));
  EXPECT_THAT(messageFor(header + nodes + elements(1, "9 140 2 0 1 1 2 3 4\n")),
              HasSubstr("element type 140 is not known"));
  EXPECT_THAT(messageFor(header + nodes + elements(1, "1 1 2 0 1 1 2\n")),
              HasSubstr("the mesh has no triangles and no tetrahedra."));
}

TEST(GmshErrors, ElementsMustNotBeInverted)
{
  EXPECT_THAT(messageFor(header + nodes + elements(2, "11 2 2 0 1 1 2 3\n12 2 2 0 1 3 1 4\n")),
              HasSubstr("1 of 2 elements are inverted; the first is element 12 at (0.333333, 0.666667)."));
}

TEST(GmshErrors, ElementsMustNotOverlap)
{
  EXPECT_THAT(messageFor(header + nodes + elements(2, "1 2 2 0 1 1 2 3\n2 2 2 0 1 1 2 3\n")),
              HasSubstr("listed twice"));
}

TEST(GmshErrors, TrianglesMustLieInAPlane)
{
  EXPECT_THAT(
      messageFor(header + "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 1 0 1\n$EndNodes\n" + elements(1, "1 2 2 0 1 1 2 3\n")),
      HasSubstr("do not lie in a plane z = constant"));
}

TEST(GmshErrors, SidesMustBeFacetsOnTheBoundary)
{
  const std::string names = "$PhysicalNames\n1\n1 1 \"side\"\n$EndPhysicalNames\n";
  const std::string cells = "2 2 2 0 1 1 2 3\n3 2 2 0 1 1 3 4\n";
  EXPECT_THAT(messageFor(header + names + nodes + elements(3, "1 1 2 1 1 2 4\n" + cells)),
              HasSubstr("element 1 of physical group \"side\" is not a facet of any cell."));
  EXPECT_THAT(messageFor(header + names + nodes + elements(3, "1 1 2 1 1 1 3\n" + cells)),
              HasSubstr("1 facets of side \"side\" are not on the boundary"));
}

TEST(GmshErrors, NamesMustBeClosed)
{
  EXPECT_THAT(messageFor(header + "$PhysicalNames\n1\n1 1 \"side\n$EndPhysicalNames\n"),
              HasSubstr("the name has no closing quote"));
}

TEST(GmshErrors, RegionsMustExist)
{
  EXPECT_THAT(messageFor(header + nodes + elements(1, "1 2 2 4 1 1 2 3\n"), strings("Regions", "punch")),
              HasSubstr("there is no physical group \"punch\" of cells; there are: physical_4."));
}

TEST(GmshErrors, SizeFactorIsForScripts)
{
  EXPECT_THAT(messageFor(header, number("Mesh Size Factor", "2")),
              HasSubstr("this key changes how a .geo file is meshed"));
  EXPECT_THAT(messageFor(header, number("Mesh Size Factor", "0")), HasSubstr("Mesh Size Factor"));
  EXPECT_THAT(messageFor(header, integer("Maximum Seconds", "2")),
              HasSubstr("this key changes how a .geo file is meshed"));
  EXPECT_THAT(messageFor(header, boolean("Allow Commands", "true")),
              HasSubstr("this key changes how a .geo file is meshed"));
}

TEST(GmshErrors, ScriptsReportGmshsOwnMessage)
{
  EXPECT_THAT(messageOf(gmsh(scratchFile("wrong.geo", "Point(1) = {0, 0;\n"))),
              AllOf(HasSubstr("gmsh cannot read the script"), HasSubstr("line 1")));
  EXPECT_THAT(messageOf(gmsh(scratchFile("none.geo", "Point(1) = {0, 0, 0};\n"))),
              HasSubstr("the script makes no surface and no volume."));
  EXPECT_THAT(messageOf(gmsh("nowhere.geo")), HasSubstr("the file cannot be read"));
}

TEST(GmshErrors, ScriptsWithoutEndAreEnded)
{
  const std::string loop = scratchFile("loop.geo", "For i In {0:1e9}\n x = i;\nEndFor\n");
  EXPECT_THAT(messageOf(gmsh(loop, integer("Maximum Seconds", "1"))),
              AllOf(HasSubstr("test.xml:"), HasSubstr("loop.geo: gmsh did not finish within 1 s"),
                    HasSubstr("raise \"Maximum Seconds\" or mesh the script beforehand (gmsh -2 FILE.geo")));
  const std::string fine = scratchFile("fine.geo", square + "Mesh.MeshSizeFactor = 1e-4;\n");
  EXPECT_THAT(messageOf(gmsh(fine, integer("Maximum Seconds", "1"))), HasSubstr("did not finish within 1 s"));
}

TEST(GmshErrors, ScriptsTakeNoMoreThanTheFreeMemory)
{
  if (isSanitized())
    GTEST_SKIP() << "its shadow memory does not fit under a limit";
  EXPECT_GT(freeMemory(), 1 << 20);
  const std::string fine = scratchFile("fine.geo", square + "Mesh.MeshSizeFactor = 2e-3;\n");
  const std::int64_t limit = std::int64_t(200) << 20; // the library takes most of it
  EXPECT_THAT(
      [&] {
        meshGeoFile(fine, 1.0, {limit, 100});
      },
      ThrowsMessage<FileError>(HasSubstr("gmsh asks for more memory than is free")));
}

TEST(GmshErrors, ScriptsThatEndGmshAreNamed)
{
  EXPECT_THAT(messageOf(gmsh(scratchFile("exit.geo", square + "Exit;\n"))),
              HasSubstr("the script ended gmsh before it had a mesh"));
}

TEST(GmshErrors, ScriptsStartProgramsOnlyIfTheDeckAllowsIt)
{
  const std::string mark = scratchPath("mark"), touch = "touch " + mark;
  const std::string harmless = scratchFile("square.geo", square);
  for (const std::string& line : {"SystemCall \"" + touch + "\";", "NonBlockingSystemCall \"" + touch + "\";",
                                  "For i In {1:1}\n SystemCall StrCat(\"tou\", \"ch " + mark + "\");\nEndFor",
                                  "OnelabRun(\"solver\", \"" + touch + "\");",
                                  "Macro hidden\n SystemCall \"" + touch + "\";\nReturn\nCall hidden;"})
  {
    const std::string script = scratchFile("command.geo", square + line + "\n");
    std::filesystem::remove(mark);
    EXPECT_THAT(messageOf(gmsh(script)),
                AllOf(HasSubstr("command.geo: the script starts another program"),
                      HasSubstr("if you trust it, set \"Allow Commands\" = true, or mesh the script beforehand")))
        << line;
    EXPECT_FALSE(std::filesystem::exists(mark)) << line;
  }
  const std::string script = scratchFile("command.geo", square + "SystemCall \"" + touch + "\";\n");
  EXPECT_NEAR(volume(readMesh(gmsh(script, boolean("Allow Commands", "true")))), 1.0, 1e-12);
  EXPECT_TRUE(std::filesystem::exists(mark));
  const std::string including = scratchFile("including.geo", "Include \"" + script + "\";\n");
  EXPECT_THAT(messageOf(gmsh(including)), HasSubstr("starts another program"));
  EXPECT_NEAR(volume(readMesh(gmsh(harmless))), 1.0, 1e-12);
}

TEST(GmshErrors, ScriptsThatAskGetTheirDefaults)
{
  const std::string asking = "size = GetValue(\"How fine?\", 1);\n";
  EXPECT_NEAR(volume(readMesh(gmsh(scratchFile("ask.geo", asking + square)))), 1.0, 1e-12);
}

} // namespace
