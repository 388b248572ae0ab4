#include "ndframe/mesh/mesh_bytes.hpp"

#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;

TEST(MeshBytes, ReadBackToTheSameMesh)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, 1, 0, 0, 1};
  mesh.cells = {0, 1, 2};
  mesh.sides = {{"bottom", {{0, 2}}}, {"", {}}};
  mesh.notes = {"a note"};
  mesh.groups = {{{}, {"core", "steel"}}, {1}};
  const std::string bytes = toBytes(mesh);
  const Mesh back = meshFromBytes(bytes);
  EXPECT_EQ(back.dim, mesh.dim);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.cells, mesh.cells);
  ASSERT_EQ(back.sides.size(), 2U);
  EXPECT_EQ(back.sides[0].name, "bottom");
  ASSERT_EQ(back.sides[0].facets.size(), 1U);
  EXPECT_EQ(back.sides[0].facets[0].local, 2);
  EXPECT_TRUE(back.sides[1].facets.empty());
  EXPECT_EQ(back.notes, mesh.notes);
  EXPECT_EQ(back.groups.names, mesh.groups.names);
  EXPECT_EQ(back.groups.kind, mesh.groups.kind);
  EXPECT_EQ(toBytes(back), bytes);
}

TEST(MeshBytes, ThatAreNotWholeAreRefused)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0};
  mesh.sides = {{"bottom", {{0, 2}}}, {"", {}}};
  mesh.notes = {"a note"};
  const std::string bytes = toBytes(mesh);
  EXPECT_THROW(meshFromBytes(bytes + "x"), InternalError);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(meshFromBytes(std::string_view(bytes).substr(0, length)), InternalError);
}
