#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "ndframe/adaptivity/refinement.hpp"
#include "persistent_remesh.hpp"

using namespace ndframe;

namespace
{

/// Two halves of a disc of radius 1, y > 0 ("up") and y < 0 ("down"), that share the curve "contact".
const char* const disc = R"(
Point(1) = {0, 0, 0, 0.4}; Point(2) = {1, 0, 0, 0.4}; Point(3) = {-1, 0, 0, 0.4};
Point(4) = {0, 1, 0, 0.4}; Point(5) = {0, -1, 0, 0.4};
Line(1) = {3, 2}; Circle(2) = {2, 1, 4}; Circle(3) = {4, 1, 3}; Circle(4) = {3, 1, 5}; Circle(5) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1}; Curve Loop(2) = {-1, 4, 5}; Plane Surface(2) = {2};
Physical Curve("contact") = {1}; Physical Surface("up") = {1}; Physical Surface("down") = {2};
)";

/// The same names; both boundaries cross themselves.
const char* const crossedDisc = R"(
Point(2) = {1, 0, 0, 0.4}; Point(3) = {-1, 0, 0, 0.4}; Point(4) = {0.5, 1, 0, 0.4}; Point(5) = {-0.5, 1, 0, 0.4};
Point(6) = {0.5, -1, 0, 0.4}; Point(7) = {-0.5, -1, 0, 0.4};
Line(1) = {3, 2}; Line(2) = {2, 5}; Line(3) = {5, 4}; Line(4) = {4, 3}; Line(5) = {3, 6}; Line(6) = {6, 7}; Line(7) = {7, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Curve Loop(2) = {-1, 5, 6, 7}; Plane Surface(2) = {2};
Physical Curve("contact") = {1}; Physical Surface("up") = {1}; Physical Surface("down") = {2};
)";

std::shared_ptr<const MeshSource> source(const std::vector<std::string>& settings)
{
  Registry<MeshSource> registry("mesh");
  registerMeshSources(registry);
  return registry.build(settings);
}

std::unique_ptr<RefinedMeshes> begin(const FirstMeshes& first)
{
  Registry<Refinement> registry("refinement", "Bisection");
  registerRefinements(registry);
  static const Comm comm = Comm::single();
  return registry.build({"Type=Remesh"})->begin(first, comm);
}

/// The facets of both meshes' side "contact", by their middles.
std::vector<FacetTwin> twinsOf(const std::vector<Mesh>& meshes)
{
  const auto middle = [&](std::size_t b, Facet facet) {
    int ends[2];
    facetVertices(meshes[b], facet, ends);
    return 0.5 * (meshes[b].point(ends[0])[0] + meshes[b].point(ends[1])[0]);
  };
  std::vector<FacetTwin> twins;
  for (const Facet first : meshes[0].findSide("contact")->facets)
    for (const Facet second : meshes[1].findSide("contact")->facets)
      if (std::abs(middle(0, first) - middle(1, second)) < 1e-9)
        twins.push_back({0, first, 1, second});
  return twins;
}

FirstMeshes halfDiscs()
{
  const std::string path = fmt::format("{}ndframe-disc-{}.geo", testing::TempDir(), getpid());
  std::ofstream(path) << disc;
  FirstMeshes first;
  for (const char* region : {"up", "down"}) {
    first.sources.push_back(source({"Type=Gmsh", "File=" + path, std::string("Regions={") + region + "}"}));
    first.meshes.push_back(first.sources.back()->read());
  }
  first.twins = twinsOf(first.meshes);
  return first;
}

/// The same area everywhere.
SizeField sizesOf(const std::vector<Mesh>& meshes, double area)
{
  SizeField sizes;
  for (const Mesh& mesh : meshes)
    sizes.emplace_back(std::size_t(mesh.numCells()), CellSize{std::log2(area), 0.0, -100.0, {}});
  return sizes;
}

double areaOf(const Mesh& mesh)
{
  double area = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    area += cellMeasure(mesh, c);
  return area;
}

/// Two cubes on each other that share a face; more: what else the script says.
std::string stackedCubesScript(const std::string& more = {})
{
  const std::string path = fmt::format("{}ndframe-cubes-{}.geo", testing::TempDir(), getpid());
  std::ofstream(path) << "SetFactory(\"OpenCASCADE\"); Mesh.MeshSizeMax = 0.4;\n"
                         "Box(1) = {0, 0, 0, 1, 1, 1}; Box(2) = {0, 0, -1, 1, 1, 1}; Coherence;\n"
                         "Physical Volume(\"up\") = {1}; Physical Volume(\"down\") = {2};\n"
                         "Physical Surface(\"contact\") = Surface In BoundingBox {-0.1, -0.1, -0.1, 1.1, 1.1, 0.1};\n"
                      << more;
  return path;
}

FirstMeshes stackedCubes()
{
  const std::string path = stackedCubesScript();
  FirstMeshes first;
  for (const char* region : {"up", "down"}) {
    first.sources.push_back(source({"Type=Gmsh", "File=" + path, std::string("Regions={") + region + "}"}));
    first.meshes.push_back(first.sources.back()->read());
  }
  first.twins = commonFacets(first.meshes);
  return first;
}

} // namespace

TEST(RemeshRefinement, BeginsWithTheGivenMeshes)
{
  const FirstMeshes first = halfDiscs();
  const auto meshes = begin(first);
  std::vector<int> own(std::size_t(first.meshes[0].numCells()));
  std::iota(own.begin(), own.end(), 0);
  EXPECT_EQ(meshes->meshes()[0].points, first.meshes[0].points);
  EXPECT_EQ(meshes->ancestors()[0], own);
}

TEST(RemeshRefinement, MakesCellsOfTheWantedAreasThatFollowTheCircle)
{
  const auto first = begin(halfDiscs());
  const double area = 1e-3;
  const auto second = first->refined(sizesOf(first->meshes(), area));
  const auto third = second->refined(sizesOf(second->meshes(), area));
  for (const Mesh& mesh : third->meshes()) {
    EXPECT_NEAR(areaOf(mesh), 0.5 * std::acos(-1.0), 2e-3);
    EXPECT_NEAR(areaOf(mesh) / mesh.numCells(), area, 0.1 * area);
  }
}

TEST(RemeshRefinement, SidesGoOnMatching)
{
  const auto first = begin(halfDiscs());
  SizeField sizes = sizesOf(first->meshes(), 0.05);
  for (CellSize& size : sizes[1])
    size.logMeasure = std::log2(2e-3);
  const auto next = first->refined(sizes);
  const std::size_t facets = next->meshes()[0].findSide("contact")->facets.size();
  EXPECT_GT(facets, 20u);
  EXPECT_EQ(twinsOf(next->meshes()).size(), facets);
  EXPECT_EQ(next->meshes()[1].findSide("contact")->facets.size(), facets);
}

TEST(RemeshRefinement, SizesFallTowardsACorner)
{
  const auto first = begin(halfDiscs());
  SizeField sizes = sizesOf(first->meshes(), 1e-2);
  for (auto& body : sizes)
    for (CellSize& size : body)
      size = {std::log2(0.02), 1.0, std::log2(1e-7), {{1.0, 0.0, 0.0}, {}}}; // area 0.02 r^2
  const auto next = first->refined(sizes);
  for (const Mesh& mesh : next->meshes())
    for (int c = 0; c < mesh.numCells(); ++c) {
      const std::array<double, 3> centre = cellCentre(mesh, c);
      const double wanted = std::exp2(sizes[0][0].logMeasureAt(centre));
      EXPECT_LT(cellMeasure(mesh, c), 4.0 * wanted) << centre[0] << ", " << centre[1];
    }
}

TEST(RemeshRefinement, AncestorsHoldTheCentres)
{
  const auto first = begin(halfDiscs());
  const auto next = first->refined(sizesOf(first->meshes(), 5e-3));
  for (std::size_t b = 0; b < 2; ++b)
    for (int c = 0; c < next->meshes()[b].numCells(); ++c) {
      const std::array<double, 3> centre = cellCentre(next->meshes()[b], c);
      if (std::hypot(centre[0], centre[1]) > 0.9)
        continue; // may lie beside the chords of the first mesh
      const Mesh& mesh = first->meshes()[b];
      const int* v = mesh.cell(next->ancestors()[b][std::size_t(c)]);
      for (int k = 0; k < 3; ++k) {
        const double *p = mesh.point(v[k]), *q = mesh.point(v[(k + 1) % 3]);
        EXPECT_GE((q[0] - p[0]) * (centre[1] - p[1]) - (q[1] - p[1]) * (centre[0] - p[0]), 0.0);
      }
    }
}

TEST(RemeshRefinement, BisectsWhereGmshGivesUp)
{
  // The script that the first meshes came from has a boundary that crosses itself now.
  const FirstMeshes first = halfDiscs();
  const auto meshes = begin(first);
  std::ofstream(fmt::format("{}ndframe-disc-{}.geo", testing::TempDir(), getpid())) << crossedDisc;
  const auto next = meshes->refined(sizesOf(meshes->meshes(), 1e-2));
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_GT(next->meshes()[b].numCells(), first.meshes[b].numCells());
    EXPECT_NEAR(areaOf(next->meshes()[b]), areaOf(first.meshes[b]), 1e-12); // the polygon stays
    EXPECT_EQ(next->ancestors()[b].size(), std::size_t(next->meshes()[b].numCells()));
  }
  EXPECT_EQ(twinsOf(next->meshes()).size(), next->meshes()[0].findSide("contact")->facets.size());
  std::ofstream(fmt::format("{}ndframe-disc-{}.geo", testing::TempDir(), getpid())) << disc;
  const auto third = next->refined(sizesOf(next->meshes(), 1e-3)); // and gmsh follows the circle again
  for (const Mesh& mesh : third->meshes())
    EXPECT_NEAR(areaOf(mesh), 0.5 * std::acos(-1.0), 2e-3);
}

TEST(PersistentRemesh, AsksAgainUntilThereIsAMesh)
{
  const std::vector<WantedMesh> wanted{{Mesh(), {0.5, 0.25}}};
  for (int failures = 0; failures < 5; ++failures) {
    std::vector<std::pair<GmshAlgorithm, double>> asked;
    const auto meshes = remeshPersistently(wanted, [&](const std::vector<WantedMesh>& now, GmshAlgorithm algorithm) {
      EXPECT_LE(now[0].lengths[1], 0.25);
      EXPECT_DOUBLE_EQ(now[0].lengths[0], 2.0 * now[0].lengths[1]);
      for (const auto& before : asked)
        EXPECT_NE(before, std::pair(algorithm, now[0].lengths[0]));
      asked.emplace_back(algorithm, now[0].lengths[0]);
      if (int(asked.size()) <= failures)
        throw RemeshFailure("gmsh gives up");
      return std::vector<Mesh>(1);
    });
    EXPECT_EQ(meshes.size(), 1u);
    EXPECT_EQ(int(asked.size()), failures + 1);
    EXPECT_EQ(asked.front(), std::pair(GmshAlgorithm::FrontalDelaunay, 0.5));
  }
}

TEST(PersistentRemesh, EndsWithTheFirstReason)
{
  int asked = 0;
  try {
    remeshPersistently({}, [&](const auto&, GmshAlgorithm) -> std::vector<Mesh> {
      throw RemeshFailure("reason " + std::to_string(++asked));
    });
    ADD_FAILURE() << "it has no mesh";
  } catch (const RemeshFailure& failure) {
    EXPECT_STREQ(failure.what(), "reason 1");
  }
  EXPECT_EQ(asked, 5);
}

TEST(PersistentRemesh, DoesNotRepeatTheUsersMistakes)
{
  int asked = 0;
  EXPECT_THROW(remeshPersistently({},
                                  [&](const auto&, GmshAlgorithm) -> std::vector<Mesh> {
                                    ++asked;
                                    throw InputError("no corner there");
                                  }),
               InputError);
  EXPECT_EQ(asked, 1);
}

TEST(RemeshRefinement, NeedsScripts)
{
  FirstMeshes first;
  first.sources.push_back(source({"Type=Box", "Lower={0, 0}", "Upper={1, 1}", "Cells={2, 2}"}));
  first.meshes.push_back(first.sources.back()->read());
  EXPECT_THROW(begin(first), InputError);
}

TEST(RemeshRefinement, MakesSolidsOfTheWantedMeasuresThatMatch)
{
  const auto first = begin(stackedCubes());
  SizeField sizes = sizesOf(first->meshes(), 1e-3);
  for (CellSize& size : sizes[1])
    size.logMeasure = std::log2(4e-3);
  const auto next = first->refined(sizes);
  EXPECT_FALSE(next->areNested());
  EXPECT_EQ(next->note(), "");
  EXPECT_NEAR(areaOf(next->meshes()[0]) / next->meshes()[0].numCells(), 1e-3, 2e-4);
  const std::size_t facets = next->meshes()[0].findSide("contact")->facets.size();
  EXPECT_GT(facets, 30u);
  EXPECT_EQ(commonFacets(next->meshes()).size(), facets);
  EXPECT_EQ(next->meshes()[1].findSide("contact")->facets.size(), facets);
}

TEST(RemeshRefinement, SolidsMayAlsoBecomeCoarser)
{
  const auto first = begin(stackedCubes());
  const auto fine = first->refined(sizesOf(first->meshes(), 1e-3));
  const auto coarse = fine->refined(sizesOf(fine->meshes(), 5e-3));
  EXPECT_LT(coarse->meshes()[0].numCells(), fine->meshes()[0].numCells() / 3);
}

TEST(RemeshRefinement, AncestorsOfSolidsHoldTheCentres)
{
  const auto first = begin(stackedCubes());
  const auto next = first->refined(sizesOf(first->meshes(), 3e-3));
  for (std::size_t b = 0; b < 2; ++b)
    for (int c = 0; c < next->meshes()[b].numCells(); ++c) {
      const Mesh& mesh = first->meshes()[b];
      const std::array<double, 3> centre = cellCentre(next->meshes()[b], c);
      const int ancestor = next->ancestors()[b][std::size_t(c)];
      for (int local = 0; local < 4; ++local) {
        double normal[3], beyond = 0.0;
        facetNormal(mesh, {ancestor, local}, normal);
        const std::array<double, 3> onFacet = facetCentre(mesh, {ancestor, local});
        for (std::size_t k = 0; k < 3; ++k)
          beyond += normal[k] * (centre[k] - onFacet[k]);
        EXPECT_LE(beyond, 1e-12);
      }
    }
}

TEST(RemeshRefinement, BisectsSolidsWhereGmshGivesUp)
{
  const FirstMeshes first = stackedCubes();
  const auto meshes = begin(first);
  stackedCubesScript("Point(900) = {0.5, 0.5, 0.5}; Point(901) = {0.5, 0.5, 2}; Line(900) = {900, 901};\n"
                     "Curve{900} In Volume{1};\n"); // leaves the volume
  const auto next = meshes->refined(sizesOf(meshes->meshes(), 2e-4));
  EXPECT_NE(next->note().find("the previous cells were bisected"), std::string::npos);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_GT(next->meshes()[b].numCells(), first.meshes[b].numCells());
    EXPECT_NEAR(areaOf(next->meshes()[b]), 1.0, 1e-12);
  }
  EXPECT_EQ(commonFacets(next->meshes()).size(), next->meshes()[0].findSide("contact")->facets.size());
}

TEST(RemeshRefinement, SolidsThatMatchAreOfOneScript)
{
  FirstMeshes first = stackedCubes();
  const std::string other = fmt::format("{}ndframe-cubes-{}-other.geo", testing::TempDir(), getpid());
  std::filesystem::copy_file(fmt::format("{}ndframe-cubes-{}.geo", testing::TempDir(), getpid()), other,
                             std::filesystem::copy_options::overwrite_existing);
  first.sources[1] = source({"Type=Gmsh", "File=" + other, "Regions={down}"});
  try {
    begin(first);
    ADD_FAILURE() << "two scripts";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gmsh would not mesh two scripts alike"), std::string::npos);
  }
}
