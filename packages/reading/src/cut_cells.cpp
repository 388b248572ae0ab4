#include "cut_cells.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{
namespace
{

constexpr int gmshTriangle = 2, gmshTetrahedron = 4;

/// The face with its smallest vertex first, the direction kept.
std::vector<int> fromSmallest(const std::vector<int>& face, const int* vertices)
{
  std::vector<int> turned;
  for (const int local : face)
    turned.push_back(vertices[local]);
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  return turned;
}

std::vector<int> trianglesOf(const std::vector<int>& polygon)
{
  std::vector<int> triangles;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    triangles.insert(triangles.end(), {polygon[0], polygon[k - 1], polygon[k]});
  return triangles;
}

/// The block's cells cut: of second order only the vertices are taken.
MshBlock cut(const MshBlock& block, const CellShape& shape, int nodesPerCell)
{
  MshBlock parts{shape.dim == 2 ? gmshTriangle : gmshTetrahedron, block.groups, {}, {}};
  for (std::size_t c = 0; c < block.numbers.size(); ++c) {
    const std::vector<int> simplices = simplicesOf(shape, block.nodes.data() + c * std::size_t(nodesPerCell));
    parts.nodes.insert(parts.nodes.end(), simplices.begin(), simplices.end());
    parts.numbers.insert(parts.numbers.end(), std::size_t(shape.simplices), block.numbers[c]);
  }
  return parts;
}

} // namespace

const CellShape* findCellShape(std::string_view name)
{
  static const std::array<CellShape, 4> shapes{
      {{"quadrangle", "quadrilaterals", 2, 4, 2, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
       {"hexahedron",
        "hexahedra",
        3,
        8,
        6,
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}},
       {"prism", "prisms", 3, 6, 3, {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}}},
       {"pyramid", "pyramids", 3, 5, 2, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}}}}};
  const auto found =
      std::find_if(shapes.begin(), shapes.end(), [&](const CellShape& shape) { return name == shape.name; });
  return found == shapes.end() ? nullptr : &*found;
}

std::vector<int> simplicesOf(const CellShape& shape, const int* vertices)
{
  if (shape.dim == 2)
    return trianglesOf(fromSmallest({0, 1, 2, 3}, vertices));
  const int apex = *std::min_element(vertices, vertices + shape.vertices);
  std::vector<int> simplices;
  for (const auto& face : shape.faces) {
    const std::vector<int> polygon = fromSmallest(face, vertices);
    if (polygon.front() == apex)
      continue;
    const std::vector<int> triangles = trianglesOf(polygon);
    for (std::size_t t = 0; t < triangles.size(); t += 3)
      simplices.insert(simplices.end(), {apex, triangles[t], triangles[t + 1], triangles[t + 2]});
  }
  return simplices;
}

std::string cutNote(const std::string& which, int dim)
{
  return fmt::format("{} have been cut into {} between their vertices.", which, dim == 2 ? "triangles" : "tetrahedra");
}

std::string cutCells(MshFile& file, int dim)
{
  std::map<std::string, std::size_t> counts;
  for (MshBlock& block : file.blocks) {
    const MshElementType& type = *findMshElementType(block.type);
    const CellShape* shape = findCellShape(type.name);
    if (shape == nullptr)
      continue;
    if (shape->dim == dim)
      counts[shape->plural] += block.numbers.size();
    block = cut(block, *shape, type.nodes);
  }
  std::vector<std::string> parts;
  for (const auto& [name, count] : counts)
    parts.push_back(fmt::format("{} {}", count, name));
  return parts.empty() ? "" : cutNote(fmt::format("{}", fmt::join(parts, ", ")), dim);
}

} // namespace ndframe
