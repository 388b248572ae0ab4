// Mesh/Refine = k: the mesh of any source with its edges halved k times.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/refine.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

std::string plane(int factor, const std::string& more = {})
{
  return text("Type", "Box") + doubles("Lower", "-1, 0.5") + doubles("Upper", "2, 1.5") +
         ints("Cells", fmt::format("{}, {}", 3 * factor, 2 * factor)) + more +
         list("Splits", list("cut", text("Side", "top") + doubles("At", "0") + strings("Names", "one, other"))) +
         list("Parts", list("core", doubles("Lower", "0, 0.5") + doubles("Upper", "1, 1")));
}

std::string refine(int k)
{
  return integer("Refine", std::to_string(k));
}

std::array<double, 3> rounded(std::array<double, 3> x)
{
  for (double& value : x)
    value = std::round(1e9 * value) * 1e-9;
  return x;
}

/// The cells by centres, each with the groups that it belongs to.
std::vector<std::pair<std::array<double, 3>, std::vector<std::string>>> cellsOf(const Mesh& mesh)
{
  std::vector<std::pair<std::array<double, 3>, std::vector<std::string>>> cells;
  for (int c = 0; c < mesh.numCells(); ++c)
    cells.emplace_back(rounded(cellCentre(mesh, c)), mesh.groups.names[std::size_t(mesh.groups.kind[std::size_t(c)])]);
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<std::array<double, 3>> facetsOf(const Mesh& mesh, const std::string& side)
{
  std::vector<std::array<double, 3>> facets;
  for (const Facet facet : mesh.findSide(side)->facets)
    facets.push_back(rounded(facetCentre(mesh, facet)));
  std::sort(facets.begin(), facets.end());
  return facets;
}

struct Source
{
  const char* name;
  std::string entries;
};

void PrintTo(const Source& source, std::ostream* out)
{
  *out << source.name;
}

class RefineOfSource : public testing::TestWithParam<Source>
{};

} // namespace

TEST(RefineOfBox, MakesTheCellsSidesAndPartsOfTheFinerGrid)
{
  for (const int k : {1, 2, 3}) {
    const Mesh refined = readMesh(plane(1, refine(k))), fine = readMesh(plane(1 << k));
    EXPECT_EQ(cellsOf(refined), cellsOf(fine));
    ASSERT_EQ(refined.sides.size(), fine.sides.size());
    for (const Side& side : fine.sides)
      EXPECT_EQ(facetsOf(refined, side.name), facetsOf(fine, side.name)) << side.name;
  }
}

TEST(RefineOfBox, ByZeroIsTheBoxAndSaysNothing)
{
  expectSameMesh(readMesh(plane(1, refine(0))), readMesh(plane(1)));
  EXPECT_TRUE(readMesh(plane(1, refine(0))).notes.empty());
}

TEST(RefineOfBox, SaysHowManyCellsThereWere)
{
  EXPECT_THAT(readMesh(plane(1, refine(2))).notes, testing::ElementsAre("Refine = 2: 12 cells became 192."));
}

TEST_P(RefineOfSource, HalvesEdgesAndKeepsBodyAndSides)
{
  const Mesh mesh = readMesh(GetParam().entries), refined = readMesh(GetParam().entries + refine(1));
  expectSameMesh(refined, refineUniformly(mesh));
  EXPECT_NEAR(volume(refined) / volume(mesh), 1.0, 1e-13);
  ASSERT_FALSE(mesh.sides.empty());
  for (const Side& side : mesh.sides)
    EXPECT_NEAR(measure(refined, *refined.findSide(side.name)) / measure(mesh, side), 1.0, 1e-13);
  EXPECT_LT(boundaryDefect(refined), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    All, RefineOfSource,
    testing::Values(Source{"Plane", plane(1)},
                    Source{"Solid", text("Type", "Box") + doubles("Lower", "0, 0, 0") + doubles("Upper", "3, 2, 1") +
                                        ints("Cells", "3, 2, 2")},
                    Source{"PlaneScript", text("Type", "Gmsh") + text("File", dataPath("quarter-disc.geo"))},
                    Source{"SolidScript", text("Type", "Gmsh") + text("File", dataPath("cube.geo"))},
                    Source{"Msh", text("Type", "Gmsh") + text("File", NDFRAME_DECK_MESHES "/punch-foundation.msh") +
                                      strings("Regions", "punch")},
                    Source{"Exodus", text("Type", "Exodus") + text("File", NDFRAME_DECK_MESHES "/punch-foundation.e") +
                                         strings("Blocks", "punch")}),
    [](const auto& instance) { return instance.param.name; });

TEST(RefineTooOften, IsRefusedWithTheNumberThatIsPossible)
{
  const std::string large = text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1");
  EXPECT_THAT(messageOf(large + ints("Cells", "300, 300") + refine(8)),
              HasSubstr("Refine = 8 makes 1.18e+10 cells of 180 000, more than can be numbered; use at most "));
  const std::string far = text("Type", "Box") + doubles("Lower", "1e8, 1e8") + doubles("Upper", "100000001, 100000001");
  EXPECT_EQ(readMesh(far + ints("Cells", "2, 2") + refine(1)).numCells(), 32);
  EXPECT_THAT(messageOf(far + ints("Cells", "2, 2") + refine(8)),
              testing::AllOf(HasSubstr("the refined mesh cannot be used: "), HasSubstr("Use a smaller number.")));
}
