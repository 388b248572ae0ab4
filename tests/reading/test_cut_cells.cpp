#include <algorithm>
#include <numeric>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cut_cells.hpp"
#include "meshing/mesh_deck.hpp"
#include "reading/mesh_files.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::HasSubstr;

/// 1, 2, ... in an order of the seed.
std::vector<int> numbering(int size, unsigned seed)
{
  std::vector<int> numbers(std::size_t(size), 0);
  std::iota(numbers.begin(), numbers.end(), 1);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(seed));
  return numbers;
}

/// A grid of 3 x 2 quadrilaterals on 3 by 1, or of 3 x 2 x 2 hexahedra on 3 by 1 by 1, its points numbered at random
/// and those inside moved. Sides "x0" and "y1"; cells with y < 0.5 in block "low", the others in "high".
ExodusSample grid(int dim, unsigned seed)
{
  const int n[3] = {3, 2, dim == 3 ? 2 : 0};
  const auto number = numbering((n[0] + 1) * (n[1] + 1) * (n[2] + 1), seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.08, 0.08);
  ExodusSample sample;
  sample.dim = dim;
  sample.points.resize(number.size() * std::size_t(dim));
  const auto node = [&](int i, int j, int k) { return number[std::size_t((k * (n[1] + 1) + j) * (n[0] + 1) + i)]; };
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        double* x = sample.points.data() + std::size_t(node(i, j, k) - 1) * std::size_t(dim);
        const double at[3] = {double(i), j / 2.0, k / 2.0};
        const bool inside = i % 3 > 0 && j % 2 > 0 && (dim == 2 || k % 2 > 0);
        for (int d = 0; d < dim; ++d)
          x[d] = at[d] + (inside ? shift(random) : 0.0);
      }
  const char* type = dim == 2 ? "QUAD4" : "HEX8";
  sample.blocks = {{1, "low", type, 1 << dim, {}}, {2, "high", type, 1 << dim, {}}};
  sample.sideSets = {{1, "x0", {}, {}}, {2, "y1", {}, {}}};
  int element = 0;
  for (int j = 0; j < 2; ++j)
    for (int k = 0; k < std::max(1, n[2]); ++k)
      for (int i = 0; i < 3; ++i) {
        ++element;
        auto& nodes = sample.blocks[std::size_t(j)].nodes;
        for (int up = 0; up < dim - 1; ++up)
          for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            nodes.push_back(node(i + di, j + dj, k + up));
        for (const auto& [set, side] : {std::pair(i == 0 ? 0 : -1, 4), std::pair(j == 1 ? 1 : -1, 3)})
          if (set >= 0) {
            sample.sideSets[std::size_t(set)].elements.push_back(element);
            sample.sideSets[std::size_t(set)].sides.push_back(side);
          }
      }
  return sample;
}

std::string exodus(const ExodusSample& sample)
{
  const std::string path = scratchPath("cut.e");
  writeExodus(path, sample);
  return text("Type", "Exodus") + text("File", path);
}

/// The same as a .msh file of format 2.2: blocks are groups 1, 2, ..., side sets those after them.
std::string asMsh(const ExodusSample& sample)
{
  std::string nodes, elements, names;
  const std::size_t dim = std::size_t(sample.dim);
  int count = 0, tag = 0;
  for (std::size_t p = 0; p < sample.points.size() / dim; ++p)
    nodes += fmt::format("{} {} {} {}\n", p + 1, sample.points[p * dim], sample.points[p * dim + 1],
                         dim == 3 ? sample.points[p * dim + 2] : 0.0);
  for (const auto& block : sample.blocks) {
    names += fmt::format("{} {} \"{}\"\n", dim, ++tag, block.name);
    for (std::size_t first = 0; first < block.nodes.size(); first += std::size_t(block.nodesPerElement)) {
      elements += fmt::format("{} {} 2 {} 1", ++count, dim == 2 ? 3 : 5, tag);
      for (int k = 0; k < block.nodesPerElement; ++k)
        elements += fmt::format(" {}", block.nodes[first + std::size_t(k)]);
      elements += "\n";
    }
  }
  const auto nodeOf = [&](int element, int local) {
    const std::size_t perBlock = sample.blocks[0].nodes.size() / std::size_t(sample.blocks[0].nodesPerElement);
    const auto& block = sample.blocks[std::size_t(element) / perBlock];
    return block.nodes[std::size_t(element) % perBlock * std::size_t(block.nodesPerElement) + std::size_t(local)];
  };
  const CellShape& shape = *findCellShape(dim == 2 ? "quadrangle" : "hexahedron");
  for (const auto& set : sample.sideSets) {
    names += fmt::format("{} {} \"{}\"\n", dim - 1, ++tag, set.name);
    for (std::size_t i = 0; i < set.elements.size(); ++i) {
      elements += fmt::format("{} {} 2 {} 1", ++count, dim == 2 ? 1 : 3, tag);
      for (const int local : shape.faces[std::size_t(set.sides[i] - 1)])
        elements += fmt::format(" {}", nodeOf(set.elements[i] - 1, local));
      elements += "\n";
    }
  }
  return fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n{}$EndPhysicalNames\n"
                     "$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
                     tag, names, sample.points.size() / dim, nodes, count, elements);
}

void expectGrid(const Mesh& mesh, int cells)
{
  EXPECT_EQ(mesh.numCells(), cells);
  EXPECT_NEAR(volume(mesh), 3.0, 1e-12); // every simplex is positive, or the mesh would have been refused
  EXPECT_LT(boundaryDefect(mesh), 1e-14);
  ASSERT_EQ(mesh.sides.size(), 2U);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("x0")), 1.0, 1e-12);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("y1")), 3.0, 1e-12);
  double low = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    if (mesh.groups.names[std::size_t(mesh.groups.kind[std::size_t(c)])] == std::vector<std::string>{"low"})
      low += 1.0;
  EXPECT_EQ(low, 0.5 * cells);
}

} // namespace

TEST(CutCells, QuadrilateralsAndHexahedraFillTheirGridConformingly)
{
  for (const int dim : {2, 3})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const ExodusSample sample = grid(dim, seed);
      const int cells = dim == 2 ? 12 : 72;
      const Mesh mesh = readMesh(exodus(sample));
      expectGrid(mesh, cells);
      EXPECT_THAT(mesh.notes.front(), HasSubstr(dim == 2 ? "quadrilaterals of block low have been cut into triangles"
                                                         : "hexahedra of block low have been cut into tetrahedra"));
      const Mesh same = readMesh(text("Type", "Gmsh") + text("File", scratchFile("cut.msh", asMsh(sample))));
      expectGrid(same, cells);
      EXPECT_EQ(same.cells, mesh.cells);
      EXPECT_THAT(same.notes,
                  ElementsAre(dim == 2 ? "6 quadrilaterals have been cut into triangles between their vertices."
                                       : "12 hexahedra have been cut into tetrahedra between their vertices."));
    }
}

TEST(CutCells, PrismsAndPyramidsFillThem)
{
  const std::vector<double> prism{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  const std::vector<double> pyramid{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1};
  for (const auto& [name, points, expected] :
       {std::tuple("prism", prism, 0.5), std::tuple("pyramid", pyramid, 1.0 / 3.0)})
    for (unsigned seed = 0; seed < 50; ++seed) {
      const CellShape& shape = *findCellShape(name);
      const auto number = numbering(shape.vertices, seed);
      Mesh mesh{3, std::vector<double>(points.size() + 3), simplicesOf(shape, number.data()), {}, {}};
      for (int v = 0; v < shape.vertices; ++v)
        std::copy_n(points.begin() + 3 * v, 3, mesh.points.begin() + 3 * number[std::size_t(v)]);
      ASSERT_EQ(mesh.numCells(), shape.simplices);
      for (int c = 0; c < mesh.numCells(); ++c)
        EXPECT_GT(cellMeasure(mesh, c), 0.01);
      EXPECT_NEAR(volume(mesh), expected, 1e-14);
    }
}

TEST(CutCells, OfSecondOrderAreReadByTheirVertices)
{
  ExodusSample sample;
  sample.points = {0, 0, 2, 0, 2, 1, 0, 1, 1, 0, 2, 0.5, 1, 1, 0, 0.5, 1, 0.5};
  sample.blocks = {{1, "plate", "QUAD9", 9, {1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  const Mesh mesh = readMesh(exodus(sample));
  EXPECT_EQ(mesh.numPoints(), 4);
  EXPECT_NEAR(volume(mesh), 2.0, 1e-15);
}

TEST(CutCells, SidesThatDoNotExistAreRefused)
{
  ExodusSample sample = grid(2, 1);
  sample.sideSets[0].sides[0] = 5;
  EXPECT_THAT(messageOf(exodus(sample)), HasSubstr("side set x0 names side 5 of element 1, which does not exist."));
}
