#include "ndframe/reading/gmsh_converter.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cut_cells.hpp"
#include "mesh_builder.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"
#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

namespace
{

/// gmsh's order of the middle nodes.
constexpr MidNodes midNodes{{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}};

const MshElementType& typeOf(const MshBlock& block)
{
  return *findMshElementType(block.type);
}

std::string groupName(const MshFile& file, int dim, int tag)
{
  for (const MshGroup& group : file.groups)
    if (group.dim == dim && group.tag == tag)
      return gmshGroupName(group.name, tag);
  return gmshGroupName("", tag);
}

bool hasGroup(const MshBlock& block, const std::set<int>& groups)
{
  return std::any_of(block.groups.begin(), block.groups.end(), [&](int tag) { return groups.count(tag) > 0; });
}

/// Tags of the physical groups of a dimension that have elements.
std::set<int> groupsOf(const MshFile& file, int dim)
{
  std::set<int> tags;
  for (const MshBlock& block : file.blocks)
    if (typeOf(block).dim == dim)
      tags.insert(block.groups.begin(), block.groups.end());
  return tags;
}

/// Turns the contents of a .msh file into a mesh.
class GmshConverter
{
public:
  /// regions: names of the physical groups to keep; empty for all.
  GmshConverter(MshFile file, std::vector<std::string> regions);
  Mesh convert();

private:
  void addCells();
  void addSides();
  void noteEmptyGroups();
  std::set<int> selectedRegions() const;
  std::vector<Facet> facetsOf(int tag, const std::string& name, const VertexTuples& facets) const;

  MshFile file_;
  std::vector<std::string> regions_;
  int dim_;
  MeshBuilder builder_;
};

int dimensionOf(const MshFile& file)
{
  int dim = 0;
  for (const MshBlock& block : file.blocks)
    dim = std::max(dim, typeOf(block).dim);
  if (dim < 2)
    throw FileError("the mesh has no triangles and no tetrahedra.");
  return dim;
}

GmshConverter::GmshConverter(MshFile file, std::vector<std::string> regions)
    : file_(std::move(file)), regions_(std::move(regions)), dim_(dimensionOf(file_)),
      builder_(dim_, std::move(file_.coordinates))
{
  if (std::string note = cutCells(file_, dim_); !note.empty())
    builder_.addNote(std::move(note));
}

Mesh GmshConverter::convert()
{
  addCells();
  addSides();
  noteEmptyGroups();
  try {
    return builder_.finish();
  } catch (const FileError& error) {
    throw FileError(error.what() +
                    choiceHint(regions_.empty() ? cellGroupsOf(file_) : std::vector<std::string>{}, "Regions"));
  }
}

std::set<int> GmshConverter::selectedRegions() const
{
  std::set<int> all = groupsOf(file_, dim_);
  if (regions_.empty())
    return all;
  std::set<int> selected;
  const std::vector<std::string> names = cellGroupsOf(file_);
  for (const int tag : all)
    if (std::find(regions_.begin(), regions_.end(), groupName(file_, dim_, tag)) != regions_.end())
      selected.insert(tag);
  for (const std::string& region : regions_)
    if (std::find(names.begin(), names.end(), region) == names.end())
      throw FileError(fmt::format("there is no physical group \"{}\" of cells; there are: {}.", region,
                                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  return selected;
}

void GmshConverter::addCells()
{
  const std::set<int> selected = selectedRegions();
  for (const MshBlock& block : file_.blocks) {
    const MshElementType& type = typeOf(block);
    if (type.dim != dim_ || !(selected.empty() || hasGroup(block, selected)))
      continue;
    if (type.nodes != dim_ + 1 && type.nodes != (dim_ + 1) * (dim_ + 2) / 2)
      throw FileError(fmt::format("element {} is a {} of order {} with {} nodes; only elements of order 1 and 2 are "
                                  "read.",
                                  block.numbers.front(), type.name, type.order, type.nodes));
    std::vector<std::string> groups;
    for (const int tag : block.groups)
      groups.push_back(groupName(file_, dim_, tag));
    builder_.addCells(block.nodes, type.nodes, block.numbers, midNodes, std::move(groups));
  }
  // Format 2.2 lists an element once for each of its groups.
  if (selected.size() > 1)
    builder_.dropRepeatedCells();
}

std::vector<Facet> GmshConverter::facetsOf(int tag, const std::string& name, const VertexTuples& facets) const
{
  std::vector<Facet> found;
  for (const MshBlock& block : file_.blocks) {
    const MshElementType& type = typeOf(block);
    if (type.dim != dim_ - 1 || !hasGroup(block, {tag}))
      continue;
    for (std::size_t e = 0; e < block.numbers.size(); ++e) {
      std::array<int, 3> vertices{};
      std::copy_n(block.nodes.begin() + std::ptrdiff_t(e) * type.nodes, dim_, vertices.begin());
      const auto [first, last] = facets.find(vertices.data());
      if (first < last)
        found.push_back({facets.at(first) / (dim_ + 1), facets.at(first) % (dim_ + 1)});
      else if (regions_.empty())
        throw FileError(
            fmt::format("element {} of physical group \"{}\" is not a facet of any cell.", block.numbers[e], name));
    }
  }
  return found;
}

void GmshConverter::addSides()
{
  const VertexTuples facets = allFacets(builder_.cells(), builder_.numNodes());
  for (const int tag : groupsOf(file_, dim_ - 1)) {
    const std::string name = groupName(file_, dim_ - 1, tag);
    std::vector<Facet> side = facetsOf(tag, name, facets);
    if (!side.empty()) // with regions chosen, the sides of the others are left out
      builder_.addSide(name, std::move(side));
  }
}

void GmshConverter::noteEmptyGroups()
{
  for (const MshGroup& group : file_.groups)
    if (group.dim >= dim_ - 1 && groupsOf(file_, group.dim).count(group.tag) == 0)
      builder_.addNote(fmt::format("The physical group \"{}\" has no elements and is left out.", group.name));
}

} // namespace

std::vector<std::string> cellGroupsOf(const MshFile& file)
{
  const int dim = dimensionOf(file);
  std::vector<std::string> names;
  for (const int tag : groupsOf(file, dim))
    names.push_back(groupName(file, dim, tag));
  return names;
}

std::string gmshGroupName(const std::string& name, int tag)
{
  return name.empty() ? fmt::format("physical_{}", tag) : name;
}

Mesh meshFromMsh(MshFile file, std::vector<std::string> regions)
{
  return GmshConverter(std::move(file), std::move(regions)).convert();
}

} // namespace ndframe
