#include "ndframe/io/exodus_writer.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>

#include "exodus_content.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// [dim - 2][order - 1]. The order of the nodes within an element is ours.
constexpr std::array<std::array<const char*, 2>, 2> elementNames{{{"TRI3", "TRI6"}, {"TETRA4", "TETRA10"}}};

/// Exodus's number of our local facet k, the one opposite to vertex k. Exodus counts a triangle's sides 01, 12, 20 and
/// a tetrahedron's 013, 123, 023, 012, so triangles need the first three of these numbers.
constexpr std::array exodusSideNumber{2, 3, 1, 4};

constexpr std::array coordinateNames{"x", "y", "z"};

/// Blocks, sets and variables are numbered from 1 in the file.
int idOf(std::size_t index)
{
  return int(index) + 1;
}

// A NetCDF-3 file is moved on disk when its header grows: everything is defined before any array is written, and all
// blocks or sets at once, for each call rewrites the header.

void defineBlocks(ExodusFile& file, const ExodusLayout& layout)
{
  std::vector<int> ids, cells, nodesPerCell;
  std::vector<std::string> types;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const NodeMap& nodes = *(*layout.bodies)[std::size_t(layout.blocks[b].body)].nodes;
    ids.push_back(idOf(b));
    types.emplace_back(elementNames[std::size_t(nodes.dim - 2)][std::size_t(nodes.order - 1)]);
    cells.push_back(layout.blocks[b].numCells);
    nodesPerCell.push_back(nodes.nodesPerCell);
  }
  CStrings texts(types);
  std::vector<int> attributes(ids.size(), 0);
  file.call("the element blocks", ex_put_concat_elem_block, ids.data(), texts.data(), cells.data(), nodesPerCell.data(),
            attributes.data(), 0);
}

/// Without entries: they are only defined.
std::vector<ex_set> sideSets(const ExodusLayout& layout)
{
  std::vector<ex_set> sets;
  for (std::size_t s = 0; s < layout.sets.size(); ++s) {
    ex_set set{};
    set.id = idOf(s);
    set.type = EX_SIDE_SET;
    set.num_entry = layout.sets[s].size;
    sets.push_back(set);
  }
  return sets;
}

void defineMesh(ExodusFile& file, const ExodusLayout& layout, const std::string& title)
{
  ex_init_params sizes{};
  headOf(title, MAX_LINE_LENGTH).copy(sizes.title, MAX_LINE_LENGTH);
  sizes.num_dim = layout.dim();
  sizes.num_nodes = layout.numNodes();
  sizes.num_elem = layout.numCells();
  sizes.num_elem_blk = std::int64_t(layout.blocks.size());
  sizes.num_side_sets = std::int64_t(layout.sets.size());
  file.call("the sizes", ex_put_init_ext, &sizes);
  defineBlocks(file, layout);
  std::vector<ex_set> sets = sideSets(layout);
  if (!sets.empty())
    file.call("the side sets", ex_put_sets, sets.size(), sets.data());
}

void defineVariables(ExodusFile& file, const ExodusLayout& layout, const ExodusVariables& variables)
{
  // Truth tables: which block or set (row) has which variable (column).
  std::vector<int> inBlocks, inSets;
  for (const ElementBlock& block : layout.blocks)
    inBlocks.insert(inBlocks.end(), variables.element.size(), block.numCells > 0 ? 1 : 0);
  for (std::size_t s = 0; s < layout.sets.size(); ++s)
    inSets.insert(inSets.end(), variables.contactSide.size(), layout.carriesVariables(s) ? 1 : 0);
  ex_var_params counts{};
  counts.num_glob = int(variables.global.size());
  counts.num_node = int(variables.nodal.size());
  counts.num_elem = int(variables.element.size());
  counts.num_sset = int(variables.contactSide.size());
  counts.elem_var_tab = inBlocks.data();
  counts.sset_var_tab = inSets.data();
  file.call("the variables", ex_put_all_var_param_ext, &counts);
}

std::string utcTime(const char* format)
{
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, MAX_STR_LENGTH + 1> text{};
  std::strftime(text.data(), text.size(), format, &parts);
  return text.data();
}

void putRecords(ExodusFile& file, const std::vector<std::string>& infoLines)
{
  CStrings record({"ndframe", NDFRAME_VERSION, utcTime("%Y-%m-%d"), utcTime("%H:%M:%SZ")});
  char* records[1][4];
  std::copy_n(record.data(), 4, records[0]);
  file.call("the quality assurance record", ex_put_qa, 1, records);
  CStrings lines(wrapInfoLines(infoLines));
  if (lines.size() > 0)
    file.call("the information records", ex_put_info, lines.size(), lines.data());
}

template <class Named>
void putNames(ExodusFile& file, ex_entity_type type, const std::vector<Named>& entries)
{
  std::vector<std::string> names;
  for (const auto& entry : entries)
    names.push_back(entry.name);
  CStrings texts(std::move(names));
  if (texts.size() > 0)
    file.call("the names of bodies or sides", ex_put_names, type, texts.data());
}

void putVariableNames(ExodusFile& file, ex_entity_type type, const std::vector<std::string>& names)
{
  CStrings texts(names);
  if (texts.size() > 0)
    file.call("the names of the variables", ex_put_variable_names, type, texts.size(), texts.data());
}

void putAllNames(ExodusFile& file, const ExodusLayout& layout, const ExodusVariables& variables)
{
  CStrings coordinates({coordinateNames.begin(), coordinateNames.begin() + layout.dim()});
  file.call("the names of the coordinates", ex_put_coord_names, coordinates.data());
  putNames(file, EX_ELEM_BLOCK, layout.blocks);
  putNames(file, EX_SIDE_SET, layout.sets);
  putVariableNames(file, EX_GLOBAL, variables.global);
  putVariableNames(file, EX_NODAL, variables.nodal);
  putVariableNames(file, EX_ELEM_BLOCK, variables.element);
  putVariableNames(file, EX_SIDE_SET, variables.contactSide);
}

void putCoordinates(ExodusFile& file, const ExodusLayout& layout)
{
  std::array<Vector, 3> x;
  for (int i = 0; i < layout.dim(); ++i)
    for (const auto& body : *layout.bodies)
      for (int node = 0; node < body.nodes->numNodes(); ++node)
        x[std::size_t(i)].push_back(body.nodes->point(node)[i]);
  file.call("the coordinates", ex_put_coord, x[0].data(), x[1].data(), x[2].data());
}

/// What belongs to the cells of a block, of an array with `perCell` entries for each cell of the body.
template <class Value>
std::vector<Value> ofBlock(const std::vector<Value>& ofBody, int perCell, const std::vector<int>* cells)
{
  if (cells == nullptr)
    return ofBody;
  std::vector<Value> chosen;
  chosen.reserve(cells->size() * std::size_t(perCell));
  for (const int cell : *cells) {
    const auto first = ofBody.begin() + std::ptrdiff_t(cell) * perCell;
    chosen.insert(chosen.end(), first, first + perCell);
  }
  return chosen;
}

void putConnectivity(ExodusFile& file, const ExodusLayout& layout)
{
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const auto& [name, body, cells, first, count] = layout.blocks[b];
    if (count == 0)
      continue;
    const NodeMap& map = *(*layout.bodies)[std::size_t(body)].nodes;
    auto nodes = ofBlock(map.cellNodes, map.nodesPerCell, cells);
    for (int& node : nodes)
      node += layout.firstNode[std::size_t(body)] + 1;
    file.call("the elements", ex_put_conn, EX_ELEM_BLOCK, idOf(b), nodes.data(), nullptr, nullptr);
  }
}

void putSideSets(ExodusFile& file, const ExodusLayout& layout)
{
  for (std::size_t s = 0; s < layout.sets.size(); ++s) {
    const auto& [name, body, facets, size] = layout.sets[s];
    std::vector<int> elements, sides;
    for (const auto& facet : *facets) {
      elements.push_back(layout.element(body, facet.cell) + 1);
      sides.push_back(exodusSide(facet.local));
    }
    if (!elements.empty())
      file.call("the facets of a side", ex_put_set, EX_SIDE_SET, idOf(s), elements.data(), sides.data());
  }
}

/// A step of an open file.
struct StepWriter
{
  ExodusFile& file;
  int step;

  void put(ex_entity_type type, std::size_t variable, int id, const Vector& values) const
  {
    file.call("the values of a variable", ex_put_var, step, type, idOf(variable), id, std::int64_t(values.size()),
              values.data());
  }
  void putAll(ex_entity_type type, int id, const std::vector<NamedField>& fields) const
  {
    for (std::size_t v = 0; v < fields.size(); ++v)
      put(type, v, id, fields[v].values);
  }
};

/// The values of one nodal variable, body after body.
Vector joined(const std::vector<std::vector<NamedField>>& fieldsOfBodies, std::size_t variable)
{
  Vector values;
  for (const auto& fields : fieldsOfBodies)
    values.insert(values.end(), fields[variable].values.begin(), fields[variable].values.end());
  return values;
}

void putStep(ExodusFile& file, const ExodusLayout& layout, const ExodusVariables& variables, int number,
             const ExodusStep& step)
{
  const StepWriter writer{file, number};
  putTime(file, number, step);
  for (std::size_t v = 0; v < variables.nodal.size(); ++v)
    writer.put(EX_NODAL, v, 1, joined(step.nodal, v));
  for (std::size_t b = 0; !step.element.empty() && b < layout.blocks.size(); ++b) {
    const ElementBlock& block = layout.blocks[b];
    if (block.numCells == 0)
      continue;
    const auto& fields = step.element[std::size_t(block.body)];
    for (std::size_t v = 0; v < fields.size(); ++v)
      writer.put(EX_ELEM_BLOCK, v, idOf(b), ofBlock(fields[v].values, 1, block.cells));
  }
  for (std::size_t s = layout.firstContact; s < layout.sets.size(); ++s)
    if (layout.carriesVariables(s))
      writer.putAll(EX_SIDE_SET, idOf(s), step.contactSide[s - layout.firstContact]);
}

} // namespace

int exodusSide(int local)
{
  return exodusSideNumber[std::size_t(local)];
}

void defineContent(ExodusFile& file, const std::string& title, const ExodusLayout& layout,
                   const ExodusVariables& variables, const std::vector<std::string>& infoLines)
{
  // The library's default cuts names after 32 characters.
  file.call("names of that length", ex_set_max_name_length, int(longestName(layout, variables)));
  defineMesh(file, layout, title);
  defineVariables(file, layout, variables);
  putRecords(file, infoLines);
  putAllNames(file, layout, variables);
}

void writeContent(const std::string& path, const std::string& title, const ExodusLayout& layout,
                  const std::vector<ExodusStep>& steps, const std::vector<std::string>& infoLines,
                  const std::function<void(ExodusFile&)>& addRecords)
{
  const auto variables = commonVariables(layout, steps);
  ExodusFile file(path);
  defineContent(file, title, layout, variables, infoLines);
  addRecords(file);
  putCoordinates(file, layout);
  putConnectivity(file, layout);
  putSideSets(file, layout);
  for (std::size_t s = 0; s < steps.size(); ++s)
    putStep(file, layout, variables, idOf(s), steps[s]);
  file.close();
}

void writeExodus(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                 const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                 const std::vector<std::string>& infoLines)
{
  for (const ExodusBody& body : bodies)
    NDFRAME_ASSERT(body.nodes != nullptr && body.nodes->numCells() > 0, "body without elements: " + body.name);
  writeContent(path, title, makeLayout(bodies, contactSides), steps, infoLines, [](ExodusFile&) {});
}

} // namespace ndframe
