#include "mesh_files.hpp"

#include <algorithm>
#include <iterator>

#include <exodusII.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ndframe::test
{

namespace
{

using Text = std::back_insert_iterator<std::string>;

/// Element types of gmsh: line, triangle, tetrahedron.
constexpr int gmshTypes[] = {0, 1, 2, 4};

std::string physicalNames(const Mesh& mesh)
{
  std::string all = fmt::format("$PhysicalNames\n{}\n", mesh.sides.size() + 1);
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    fmt::format_to(Text(all), "{} {} \"{}\"\n", mesh.dim - 1, s + 1, mesh.sides[s].name);
  fmt::format_to(Text(all), "{} 1 \"body\"\n$EndPhysicalNames\n", mesh.dim);
  return all;
}

std::string coordinates(const Mesh& mesh, int point)
{
  const double* x = mesh.point(point);
  return fmt::format("{} {} {}\n", x[0], x[1], mesh.dim == 3 ? x[2] : 0.0);
}

int numFacets(const Mesh& mesh)
{
  std::size_t n = 0;
  for (const Side& side : mesh.sides)
    n += side.facets.size();
  return int(n);
}

} // namespace

std::string asMsh22(const Mesh& mesh)
{
  std::string all = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + physicalNames(mesh);
  fmt::format_to(Text(all), "$Nodes\n{}\n", mesh.numPoints());
  for (int p = 0; p < mesh.numPoints(); ++p)
    fmt::format_to(Text(all), "{} {}", p + 1, coordinates(mesh, p));
  fmt::format_to(Text(all), "$EndNodes\n$Elements\n{}\n", mesh.numCells() + numFacets(mesh));
  int number = 0;
  const auto element = [&](int dim, int tag, const int* vertices) {
    fmt::format_to(Text(all), "{} {} 2 {} {}", ++number, gmshTypes[dim], tag, tag);
    for (int k = 0; k <= dim; ++k)
      fmt::format_to(Text(all), " {}", vertices[k] + 1);
    all += "\n";
  };
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    for (const Facet& facet : mesh.sides[s].facets) {
      int vertices[3];
      facetVertices(mesh, facet, vertices);
      element(mesh.dim - 1, int(s) + 1, vertices);
    }
  for (int c = 0; c < mesh.numCells(); ++c)
    element(mesh.dim, 1, mesh.cell(c));
  return all + "$EndElements\n";
}

std::string asMsh41(const Mesh& mesh)
{
  const auto nodeNumber = [&](int p) { return 10 + 3 * (mesh.numPoints() - p); };
  std::string all = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + physicalNames(mesh);
  // One entity per side (none of the dimensions below) and one for the cells.
  const auto entity = [&](int tag) { fmt::format_to(Text(all), "{} 0 0 0 1 1 1 1 {} 0\n", tag, tag); };
  const std::size_t n = mesh.sides.size();
  all += mesh.dim == 2 ? fmt::format("$Entities\n0 {} 1 0\n", n) : fmt::format("$Entities\n0 0 {} 1\n", n);
  for (std::size_t s = 0; s < n; ++s)
    entity(int(s) + 1);
  entity(1);
  fmt::format_to(Text(all), "$EndEntities\n$Nodes\n1 {} 1 {}\n{} 1 0 {}\n", mesh.numPoints(), nodeNumber(0), mesh.dim,
                 mesh.numPoints());
  for (int p = 0; p < mesh.numPoints(); ++p)
    fmt::format_to(Text(all), "{}\n", nodeNumber(p));
  for (int p = 0; p < mesh.numPoints(); ++p)
    all += coordinates(mesh, p);
  fmt::format_to(Text(all), "$EndNodes\n$Elements\n{} {} 1 9999999\n", n + 1, mesh.numCells() + numFacets(mesh));
  int number = 9999999;
  const auto element = [&](int dim, const int* vertices) {
    fmt::format_to(Text(all), "{}", number -= 2);
    for (int k = 0; k <= dim; ++k)
      fmt::format_to(Text(all), " {}", nodeNumber(vertices[k]));
    all += "\n";
  };
  for (std::size_t s = 0; s < n; ++s) {
    fmt::format_to(Text(all), "{} {} {} {}\n", mesh.dim - 1, s + 1, gmshTypes[mesh.dim - 1],
                   mesh.sides[s].facets.size());
    for (const Facet& facet : mesh.sides[s].facets) {
      int vertices[3];
      facetVertices(mesh, facet, vertices);
      element(mesh.dim - 1, vertices);
    }
  }
  fmt::format_to(Text(all), "{} 1 {} {}\n", mesh.dim, gmshTypes[mesh.dim], mesh.numCells());
  for (int c = 0; c < mesh.numCells(); ++c)
    element(mesh.dim, mesh.cell(c));
  return all + "$EndElements\n";
}

ExodusSample asExodusSample(const Mesh& mesh)
{
  // Number of the side opposite to our vertex k.
  constexpr int sideOf[] = {2, 3, 1, 4};
  ExodusSample sample;
  sample.dim = mesh.dim;
  sample.points = mesh.points;
  sample.blocks = {{7, "body", mesh.dim == 2 ? "TRI3" : "TETRA4", mesh.dim + 1, mesh.cells}};
  for (int& node : sample.blocks[0].nodes)
    ++node;
  for (const Side& side : mesh.sides) {
    sample.sideSets.push_back({int(sample.sideSets.size()) + 1, side.name, {}, {}});
    for (const Facet& facet : side.facets) {
      sample.sideSets.back().elements.push_back(facet.cell + 1);
      sample.sideSets.back().sides.push_back(sideOf[facet.local]);
    }
  }
  return sample;
}

void writeExodus(const std::string& path, const ExodusSample& sample, int formatFlag)
{
  int wordSize = 8;
  int fileWordSize = 8;
  const int file = ex_create(path.c_str(), EX_CLOBBER | formatFlag, &wordSize, &fileWordSize);
  ASSERT_GE(file, 0);
  const int numNodes = int(sample.points.size()) / sample.dim;
  std::size_t numElements = 0;
  for (const auto& block : sample.blocks)
    numElements += block.nodes.size() / block.nodesPerElement;
  ex_put_init(file, "test", sample.dim, numNodes, std::int64_t(numElements), std::int64_t(sample.blocks.size()), 0,
              std::int64_t(sample.sideSets.size()));
  std::vector<double> x[3];
  for (std::size_t i = 0; i < sample.points.size(); ++i)
    x[i % sample.dim].push_back(sample.points[i]);
  ex_put_coord(file, x[0].data(), x[1].data(), x[2].data());
  for (const auto& block : sample.blocks) {
    ex_put_block(file, EX_ELEM_BLOCK, block.id, block.type.c_str(),
                 std::int64_t(block.nodes.size()) / block.nodesPerElement, block.nodesPerElement, 0, 0, 0);
    ex_put_conn(file, EX_ELEM_BLOCK, block.id, block.nodes.data(), nullptr, nullptr);
    if (!block.name.empty())
      ex_put_name(file, EX_ELEM_BLOCK, block.id, block.name.c_str());
  }
  for (const auto& set : sample.sideSets) {
    ex_put_set_param(file, EX_SIDE_SET, set.id, std::int64_t(set.elements.size()), 0);
    if (!set.elements.empty())
      ex_put_set(file, EX_SIDE_SET, set.id, set.elements.data(), set.sides.data());
    if (!set.name.empty())
      ex_put_name(file, EX_SIDE_SET, set.id, set.name.c_str());
  }
  EXPECT_EQ(ex_close(file), 0);
}

} // namespace ndframe::test
