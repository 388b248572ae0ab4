#include "mesh_deck.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ndframe::test
{

namespace
{

std::string entry(const std::string& key, const std::string& type, const std::string& value)
{
  return fmt::format("<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>\n", key, type, value);
}

} // namespace

std::string doubles(const std::string& key, const std::string& values)
{
  return entry(key, "Array(double)", "{" + values + "}");
}
std::string ints(const std::string& key, const std::string& values)
{
  return entry(key, "Array(int)", "{" + values + "}");
}
std::string strings(const std::string& key, const std::string& values)
{
  return entry(key, "Array(string)", "{" + values + "}");
}
std::string text(const std::string& key, const std::string& value)
{
  return entry(key, "string", value);
}
std::string number(const std::string& key, const std::string& value)
{
  return entry(key, "double", value);
}
std::string integer(const std::string& key, const std::string& value)
{
  return entry(key, "int", value);
}
std::string boolean(const std::string& key, const std::string& value)
{
  return entry(key, "bool", value);
}
std::string list(const std::string& name, const std::string& entries)
{
  return fmt::format("<ParameterList name=\"{}\">\n{}</ParameterList>\n", name, entries);
}

std::unique_ptr<MeshSource> meshSource(const std::string& entries)
{
  Registry<MeshSource> registry("mesh");
  registerMeshSources(registry);
  ListSpec meshSpec;
  meshSpec.name = "Mesh";
  meshSpec.isRequired = true;
  meshSpec.choices = registry.choices();
  ListSpec deckSpec;
  deckSpec.lists = {meshSpec};
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(list("deck", list("Mesh", entries)), "test.xml"), deckSpec, diagnostics);
  diagnostics.throwIfAny();
  return registry.build(params.sub("Mesh"));
}

Mesh readMesh(const std::string& entries)
{
  return meshSource(entries)->read();
}

std::string messageOf(const std::string& entries)
{
  try {
    readMesh(entries);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError for\n" << entries;
  return {};
}

std::string scratchPath(const std::string& name)
{
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      fmt::format("ndframe-mesh-{}-{}", test->test_suite_name(), test->name());
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

std::string scratchFile(const std::string& name, const std::string& contents)
{
  const std::string path = scratchPath(name);
  std::ofstream(path, std::ios::binary) << contents;
  return path;
}

std::string contentsOf(const std::string& path)
{
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

std::string dataPath(const std::string& name)
{
  return NDFRAME_TEST_DATA "/" + name;
}

double volume(const Mesh& mesh)
{
  double sum = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    sum += cellMeasure(mesh, c);
  return sum;
}

double measure(const Mesh& mesh, const Side& side)
{
  double sum = 0.0;
  double normal[3];
  for (const Facet& facet : side.facets)
    sum += facetNormal(mesh, facet, normal);
  return sum;
}

double boundaryDefect(const Mesh& mesh)
{
  std::map<std::vector<int>, std::vector<Facet>> facets;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int k = 0; k <= mesh.dim; ++k) {
      std::vector<int> vertices(mesh.dim);
      facetVertices(mesh, {c, k}, vertices.data());
      std::sort(vertices.begin(), vertices.end());
      facets[vertices].push_back({c, k});
    }
  double total = 0.0;
  std::array<double, 3> sum{};
  for (const auto& [vertices, cells] : facets) {
    std::array<double, 3> normal{};
    const double size = facetNormal(mesh, cells[0], normal.data());
    for (int i = 0; i < mesh.dim && cells.size() == 1; ++i)
      sum[i] += size * normal[i];
    total += cells.size() == 1 ? size : 0.0;
  }
  return std::hypot(sum[0], sum[1], sum[2]) / total;
}

double distanceFromPlane(const Mesh& mesh, const Side& side, const double* normal, double offset)
{
  double largest = 0.0;
  for (const Facet& facet : side.facets) {
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    for (int k = 0; k < mesh.dim; ++k) {
      double distance = -offset;
      for (int i = 0; i < mesh.dim; ++i)
        distance += normal[i] * mesh.point(vertices[k])[i];
      largest = std::max(largest, std::abs(distance));
    }
  }
  return largest;
}

void expectSameMesh(const Mesh& a, const Mesh& b, double tolerance)
{
  EXPECT_EQ(a.dim, b.dim);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    EXPECT_NEAR(a.points[i], b.points[i], tolerance);
  EXPECT_EQ(a.cells, b.cells);
  const auto sorted = [](const Mesh& mesh) {
    std::map<std::string, std::vector<std::pair<int, int>>> sides;
    for (const Side& side : mesh.sides) {
      auto& facets = sides[side.name];
      for (const Facet& facet : side.facets)
        facets.push_back({facet.cell, facet.local});
      std::sort(facets.begin(), facets.end());
    }
    return sides;
  };
  EXPECT_EQ(sorted(a), sorted(b));
}

} // namespace ndframe::test
