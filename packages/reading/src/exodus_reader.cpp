#include "ndframe/reading/exodus_reader.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cut_cells.hpp"
#include "joined_input.hpp"
#include "mesh_builder.hpp"
#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

/// Exodus's order of the middle nodes.
constexpr MidNodes midNodes{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The facet (by its opposite vertex) that Exodus's side numbers 1, 2, ... stand for. The sides of a triangle are its
/// vertices 12, 23, 31; those of a tetrahedron 124, 234, 134, 123.
constexpr std::array<int, 4> facetOfSide{2, 0, 1, 3};

/// Exodus's element types by how their names begin. Blocks of curves and points are left out.
struct Shape
{
  std::string_view prefix;
  int dim;
  bool simplex;
  std::string_view cutAs;               ///< gmsh's name of a cell that is cut into simplices
  std::array<int, 3> nodesPerElement{}; ///< of such a cell, first and second order
};

constexpr std::array<Shape, 8> shapes{{{"TRI", 2, true, {}, {}},
                                       {"TET", 3, true, {}, {}},
                                       {"QUAD", 2, false, "quadrangle", {4, 8, 9}},
                                       {"SHELL", 2, false, "quadrangle", {4, 8, 9}},
                                       {"HEX", 3, false, "hexahedron", {8, 20, 27}},
                                       {"WEDGE", 3, false, "prism", {6, 15, 18}},
                                       {"PYR", 3, false, "pyramid", {5, 13, 14}},
                                       {"NSIDED", 2, false, {}, {}}}};

const Shape& shapeOf(const ExodusBlock& block)
{
  static constexpr Shape lowDimensional{"", 1, false, {}, {}};
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& shape) {
    return block.type.compare(0, shape.prefix.size(), shape.prefix) == 0;
  });
  return found == shapes.end() ? lowDimensional : *found;
}

/// Turns an Exodus file into a mesh.
class ExodusConverter
{
public:
  /// file: which must live as long. wanted: names or numbers of the blocks to keep; empty for all. isPart: others have
  /// the rest of the mesh, and perhaps of its sides.
  ExodusConverter(const ExodusMesh& file, const std::vector<std::string>& wanted, bool isPart)
      : file_(file), wanted_(wanted), isPart_(isPart), blocks_(chosenBlocks()), dim_(dimension()),
        builder_(dim_, file_.coordinates()), cellOfElement_(file_.numElements(), -1)
  {}

  Mesh convert();
  /// Per point and per cell of the mesh of a part what it is in the file.
  const std::vector<int>& usedNodes() const { return usedNodes_; }
  std::vector<int> usedElements() const;

private:
  std::vector<ExodusBlock> chosenBlocks() const;
  int dimension() const;
  void addBlock(const ExodusBlock& block);
  void addCutBlock(const ExodusBlock& block, const CellShape& shape);
  std::vector<Facet> facetsOnSide(int element, int side, const std::string& set) const;
  void addSide(const ExodusSideSet& set);

  const ExodusMesh& file_;
  const std::vector<std::string>& wanted_;
  bool isPart_;
  std::vector<ExodusBlock> blocks_;
  int dim_;
  MeshBuilder builder_;
  /// A block of cells that are no simplices.
  struct CutBlock
  {
    const CellShape* shape;
    int firstElement, nodesPerElement;
    std::vector<int> nodes;
  };

  std::vector<int> cellOfElement_; ///< the first of its cells
  std::vector<CutBlock> cutBlocks_;
  std::vector<int> usedNodes_;
};

std::vector<std::string> namesOf(const std::vector<ExodusBlock>& blocks)
{
  std::vector<std::string> names;
  for (const ExodusBlock& block : blocks)
    names.push_back(block.name);
  return names;
}

std::unique_ptr<ExodusMesh> opened(const std::vector<std::string>& paths)
{
  if (paths.size() == 1)
    return std::make_unique<ExodusInput>(paths.front());
  return std::make_unique<JoinedInput>(paths);
}

std::vector<ExodusBlock> ExodusConverter::chosenBlocks() const
{
  std::vector<ExodusBlock> all = file_.blocks();
  if (wanted_.empty())
    return all;
  std::vector<ExodusBlock> chosen;
  for (const std::string& wanted : wanted_) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const ExodusBlock& block) {
      return block.name == wanted || std::to_string(block.id) == wanted;
    });
    if (found == all.end())
      throw FileError(
          fmt::format("there is no element block \"{}\"; there are: {}.", wanted, fmt::join(namesOf(all), ", ")));
    chosen.push_back(*found);
  }
  return chosen;
}

int ExodusConverter::dimension() const
{
  int dim = 0;
  for (const ExodusBlock& block : blocks_)
    if (block.numElements > 0)
      dim = std::max(dim, shapeOf(block).dim);
  if (isPart_ && dim == 0) // others have its cells
    return file_.dim();
  if (dim < 2 || dim > file_.dim())
    throw FileError("the mesh has no triangles and no tetrahedra.");
  return dim;
}

void ExodusConverter::addCutBlock(const ExodusBlock& block, const CellShape& shape)
{
  CutBlock cut{&shape, block.firstElement, block.nodesPerElement, file_.nodes(block)};
  std::vector<int> simplices;
  std::vector<std::int64_t> numbers;
  for (int e = 0; e < block.numElements; ++e) {
    cellOfElement_[block.firstElement + e] = builder_.cells().numCells() + e * shape.simplices;
    const std::vector<int> parts =
        simplicesOf(shape, cut.nodes.data() + std::size_t(e) * std::size_t(block.nodesPerElement));
    simplices.insert(simplices.end(), parts.begin(), parts.end());
    numbers.insert(numbers.end(), std::size_t(shape.simplices), block.firstElement + e + 1);
  }
  builder_.addCells(simplices, dim_ + 1, numbers, midNodes, {block.name});
  builder_.addNote(cutNote(fmt::format("{} {} of block {}", block.numElements, shape.plural, block.name), dim_));
  cutBlocks_.push_back(std::move(cut));
}

void ExodusConverter::addBlock(const ExodusBlock& block)
{
  const auto& counts = shapeOf(block).nodesPerElement;
  if (const CellShape* shape = findCellShape(shapeOf(block).cutAs);
      shape != nullptr && std::find(counts.begin(), counts.end(), block.nodesPerElement) != counts.end())
    return addCutBlock(block, *shape);
  const int vertices = dim_ + 1;
  const int secondOrder = vertices * (dim_ + 2) / 2;
  if (!shapeOf(block).simplex || (block.nodesPerElement != vertices && block.nodesPerElement != secondOrder))
    throw FileError(fmt::format("the elements of block {} are of type {} with {} nodes; only TRI, TETRA, QUAD, HEX, "
                                "WEDGE and PYRAMID of first and second order are read.",
                                block.name, block.type, block.nodesPerElement));
  std::vector<std::int64_t> numbers(block.numElements);
  std::iota(numbers.begin(), numbers.end(), block.firstElement + 1);
  for (int e = 0; e < block.numElements; ++e)
    cellOfElement_[block.firstElement + e] = builder_.cells().numCells() + e;
  builder_.addCells(file_.nodes(block), block.nodesPerElement, numbers, midNodes, {block.name});
}

/// side: from 0. Of a cell that was cut: the facets whose vertices lie on the side.
std::vector<Facet> ExodusConverter::facetsOnSide(int element, int side, const std::string& set) const
{
  const auto block = std::find_if(cutBlocks_.rbegin(), cutBlocks_.rend(), [&](const CutBlock& cut) {
    return element >= cut.firstElement && element < cut.firstElement + int(cut.nodes.size()) / cut.nodesPerElement;
  });
  const int sides = block == cutBlocks_.rend() ? dim_ + 1 : int(block->shape->faces.size());
  if (side < 0 || side >= sides)
    throw FileError(fmt::format("side set {} names side {} of element {}, which does not exist.", set,
                                side + (dim_ < file_.dim() ? 3 : 1), element + 1));
  if (block == cutBlocks_.rend())
    return {{cellOfElement_[element], facetOfSide[side]}};
  const int* nodes =
      block->nodes.data() + std::size_t(element - block->firstElement) * std::size_t(block->nodesPerElement);
  const auto& face = block->shape->faces[std::size_t(side)];
  const auto isOn = [&](int vertex) {
    return std::any_of(face.begin(), face.end(), [&](int local) { return nodes[local] == vertex; });
  };
  std::vector<Facet> facets;
  for (int cell = cellOfElement_[element], end = cell + block->shape->simplices; cell < end; ++cell) {
    const int* vertices = builder_.cells().cell(cell);
    for (int local = 0; local <= dim_; ++local)
      if (dim_ ==
          std::count_if(vertices, vertices + dim_ + 1, [&](const int& v) { return &v != vertices + local && isOn(v); }))
        facets.push_back({cell, local});
  }
  return facets;
}

void ExodusConverter::addSide(const ExodusSideSet& set)
{
  // In three dimensions the first two sides of a triangle are its faces.
  const int firstSide = dim_ < file_.dim() ? 3 : 1;
  std::vector<Facet> facets;
  for (std::size_t i = 0; i < set.elements.size(); ++i) {
    const int element = set.elements[i];
    if (element < 1 || element > file_.numElements())
      throw FileError(
          fmt::format("side set {} names element {}, but there are {}.", set.name, element, file_.numElements()));
    if (cellOfElement_[element - 1] < 0)
      continue; // of a block that is left out
    const std::vector<Facet> onSide = facetsOnSide(element - 1, set.sides[i] - firstSide, set.name);
    facets.insert(facets.end(), onSide.begin(), onSide.end());
  }
  if (!facets.empty() || isPart_)
    builder_.addSide(set.name, std::move(facets));
  else if (wanted_.empty())
    builder_.addNote(fmt::format("The side set {} is empty and is left out.", set.name));
}

Mesh ExodusConverter::convert()
{
  for (const ExodusBlock& block : blocks_)
    if (shapeOf(block).dim == dim_ && block.numElements > 0)
      addBlock(block);
  for (const ExodusSideSet& set : file_.sideSets())
    addSide(set);
  if (isPart_ && !cutBlocks_.empty())
    throw FileError("cells that are parts of elements have no numbers of their own.");
  const std::vector<int>& nodes = builder_.cells().cells;
  if (isPart_ && nodes.empty())
    return {dim_, {}, {}, builder_.cells().sides, {}};
  usedNodes_ = nodes;
  std::sort(usedNodes_.begin(), usedNodes_.end());
  usedNodes_.erase(std::unique(usedNodes_.begin(), usedNodes_.end()), usedNodes_.end());
  try {
    return builder_.finish();
  } catch (const FileError& error) {
    throw FileError(error.what() +
                    choiceHint(wanted_.empty() ? namesOf(blocks_) : std::vector<std::string>{}, "Blocks"));
  }
}

std::vector<int> ExodusConverter::usedElements() const
{
  std::vector<int> elements;
  for (int element = 0; element < int(cellOfElement_.size()); ++element)
    if (cellOfElement_[element] >= 0)
      elements.push_back(element);
  std::sort(elements.begin(), elements.end(), [&](int a, int b) { return cellOfElement_[a] < cellOfElement_[b]; });
  return elements;
}

} // namespace

Mesh meshOfExodus(const std::vector<std::string>& paths, const std::vector<std::string>& wanted)
{
  return ExodusConverter(*opened(paths), wanted, false).convert();
}

NumberedMesh partOfExodus(const std::vector<std::string>& paths, const std::vector<std::string>& wanted)
{
  const JoinedInput file(paths);
  ExodusConverter converter(file, wanted, true);
  NumberedMesh part{converter.convert(), {}, {}};
  for (const int node : converter.usedNodes())
    part.points.push_back(file.nodeIds()[std::size_t(node)]);
  for (const int element : converter.usedElements())
    part.cells.push_back(file.elementIds()[std::size_t(element)]);
  return part;
}

} // namespace ndframe
