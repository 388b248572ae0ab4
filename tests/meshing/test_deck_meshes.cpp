#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

std::string deckMesh(const std::string& type, const std::string& file, const std::string& key, const std::string& body)
{
  return text("Type", type) + text("File", NDFRAME_DECK_MESHES "/" + file) + strings(key, body);
}

std::set<std::pair<double, double>> pointsOf(const Mesh& mesh, const Side& side)
{
  std::set<std::pair<double, double>> points;
  for (const Facet& facet : side.facets) {
    int v[2];
    facetVertices(mesh, facet, v);
    for (const int vertex : v)
      points.insert({mesh.point(vertex)[0], mesh.point(vertex)[1]});
  }
  return points;
}

struct File
{
  const char* type;
  const char* name;
  const char* key;
};

class DeckMeshes : public testing::TestWithParam<File>
{};

TEST_P(DeckMeshes, HoldTwoBodiesThatMatchAlongTheContact)
{
  const auto& [type, name, key] = GetParam();
  const Mesh punch = readMesh(deckMesh(type, name, key, "punch"));
  const Mesh foundation = readMesh(deckMesh(type, name, key, "foundation"));
  EXPECT_NEAR(volume(punch), 1.0, 1e-12);
  EXPECT_NEAR(volume(foundation), 2.0, 1e-12);
  for (const Mesh* body : {&punch, &foundation}) {
    EXPECT_NEAR(measure(*body, *body->findSide("contact")), 1.0, 1e-12);
    EXPECT_NEAR(measure(*body, *body->findSide("left")), 1.0, 1e-12);
    EXPECT_NEAR(measure(*body, *body->findSide("right")), 1.0, 1e-12);
    EXPECT_LT(boundaryDefect(*body), 1e-14);
    EXPECT_THAT(body->notes, testing::IsEmpty());
  }
  EXPECT_NE(punch.findSide("top"), nullptr);
  EXPECT_EQ(punch.findSide("free top"), nullptr);
  EXPECT_NEAR(measure(foundation, *foundation.findSide("free top")), 1.0, 1e-12);
  EXPECT_NEAR(measure(foundation, *foundation.findSide("bottom")), 2.0, 1e-12);
  EXPECT_EQ(pointsOf(punch, *punch.findSide("contact")), pointsOf(foundation, *foundation.findSide("contact")));
}

TEST_P(DeckMeshes, NameTheBodiesWhenAWrongOneIsAskedFor)
{
  const auto& [type, name, key] = GetParam();
  const std::string message = messageOf(deckMesh(type, name, key, "stamp"));
  EXPECT_THAT(message, HasSubstr("\"stamp\""));
  EXPECT_THAT(message, HasSubstr("punch, foundation"));
}

INSTANTIATE_TEST_SUITE_P(All, DeckMeshes,
                         testing::Values(File{"Gmsh", "punch-foundation.geo", "Regions"},
                                         File{"Gmsh", "punch-foundation.msh", "Regions"},
                                         File{"Gmsh", "punch-foundation-2.2.msh", "Regions"},
                                         File{"Exodus", "punch-foundation.e", "Blocks"}));

} // namespace
