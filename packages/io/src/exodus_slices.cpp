#include "ndframe/io/exodus_slices.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include "exodus_content.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// The layout of a share with the sizes of the whole.
ExodusLayout layoutOfWhole(ExodusLayout layout, const ExodusWhole& whole)
{
  layout.firstNode = layout.firstCell = {0};
  for (std::size_t b = 0; b < whole.numNodes.size(); ++b)
    layout.appendBody(whole.numNodes[b], whole.numCells[b]);
  int first = 0;
  for (std::size_t k = 0; k < layout.blocks.size(); ++k) {
    layout.blocks[k].firstElement = first;
    layout.blocks[k].numCells = int(whole.numElements[k]);
    first += layout.blocks[k].numCells;
  }
  for (std::size_t s = 0; s < layout.sets.size(); ++s)
    layout.sets[s].size = whole.numFacets[s];
  return layout;
}

/// One process's part of an open file. Numbers in the file are from 1.
class SliceWriter
{
public:
  SliceWriter(ExodusFile& file, const ExodusLayout& layout, const ExodusWhole& whole, const ExodusSlice& slice)
      : file_(file), layout_(layout), whole_(whole), slice_(slice)
  {}

  void putMesh()
  {
    for (std::size_t b = 0; b < whole_.numNodes.size(); ++b)
      putCoordinates(b);
    for (std::size_t k = 0; k < layout_.blocks.size(); ++k)
      putElements(k);
    for (std::size_t s = 0; s < layout_.sets.size(); ++s)
      putFacets(s);
  }

  void putStep(int number, const ExodusStep& step)
  {
    for (std::size_t b = 0; b < whole_.numNodes.size(); ++b)
      for (std::size_t v = 0; v < step.nodal[b].size(); ++v)
        put(number, EX_NODAL, v, 1, firstNode(b), chosen(step.nodal[b][v].values, slice_.ownNodes[b]));
    for (std::size_t k = 0; k < layout_.blocks.size(); ++k) {
      const std::vector<NamedField>& fields = step.element[std::size_t(layout_.blocks[k].body)];
      const std::vector<int> cells = ownCells(k);
      for (std::size_t v = 0; v < fields.size(); ++v)
        put(number, EX_ELEM_BLOCK, v, k, whole_.firstElements[k], chosen(fields[v].values, cells));
    }
    for (std::size_t s = layout_.firstContact; s < layout_.sets.size(); ++s)
      if (layout_.carriesVariables(s)) {
        const auto& fields = step.contactSide[s - layout_.firstContact];
        for (std::size_t v = 0; v < fields.size(); ++v)
          put(number, EX_SIDE_SET, v, s, slice_.firstFacets[s], chosen(fields[v].values, ownFacets(s)));
      }
  }

private:
  static Vector chosen(const Vector& values, const std::vector<int>& places)
  {
    Vector taken;
    taken.reserve(places.size());
    for (const int place : places)
      taken.push_back(values[std::size_t(place)]);
    return taken;
  }

  /// The place of the first own node among the nodes of all bodies.
  std::int64_t firstNode(std::size_t body) const
  {
    const auto& own = slice_.ownNodes[body];
    return own.empty() ? 0 : layout_.firstNode[body] + slice_.numbers[body][std::size_t(own.front())];
  }

  /// Facets of own cells by their places among those of the share.
  std::vector<int> ownFacets(std::size_t set) const
  {
    const auto& [name, body, facets, size] = layout_.sets[set];
    std::vector<int> own;
    for (std::size_t f = 0; f < facets->size(); ++f)
      if ((*facets)[f].cell < whole_.numOwnCells[std::size_t(body)])
        own.push_back(int(f));
    return own;
  }

  /// The block's own cells.
  std::vector<int> ownCells(std::size_t block) const
  {
    const int count = whole_.numOwnCells[std::size_t(layout_.blocks[block].body)];
    std::vector<int> own;
    if (const std::vector<int>* const cells = layout_.blocks[block].cells) {
      std::copy_if(cells->begin(), cells->end(), std::back_inserter(own), [count](int cell) { return cell < count; });
      return own;
    }
    own.resize(std::size_t(count));
    std::iota(own.begin(), own.end(), 0);
    return own;
  }

  void put(int step, ex_entity_type type, std::size_t variable, std::size_t object, std::int64_t first,
           const Vector& values)
  {
    if (!values.empty())
      file_.call("a part of the values of a variable", ex_put_partial_var, step, type, int(variable) + 1,
                 type == EX_NODAL ? 1 : int(object) + 1, first + 1, std::int64_t(values.size()), values.data());
  }

  void putCoordinates(std::size_t body)
  {
    const NodeMap& nodes = *(*layout_.bodies)[body].nodes;
    std::array<Vector, 3> x;
    for (const int node : slice_.ownNodes[body])
      for (std::size_t k = 0; k < x.size(); ++k)
        x[k].push_back(nodes.point(node)[k]);
    if (!x[0].empty())
      file_.call("a part of the coordinates", ex_put_partial_coord, firstNode(body) + 1, std::int64_t(x[0].size()),
                 x[0].data(), x[1].data(), x[2].data());
  }

  void putElements(std::size_t block)
  {
    const auto body = std::size_t(layout_.blocks[block].body);
    const NodeMap& nodes = *(*layout_.bodies)[body].nodes;
    const std::vector<int> cells = ownCells(block);
    std::vector<int> elements;
    elements.reserve(cells.size() * std::size_t(nodes.nodesPerCell));
    for (const int cell : cells)
      for (int a = 0; a < nodes.nodesPerCell; ++a)
        elements.push_back(int(layout_.firstNode[body] + slice_.numbers[body][std::size_t(nodes.cell(cell)[a])] + 1));
    if (!cells.empty())
      file_.call("a part of the elements", ex_put_partial_elem_conn, int(block) + 1, whole_.firstElements[block] + 1,
                 std::int64_t(cells.size()), elements.data());
  }

  void putFacets(std::size_t set)
  {
    const auto& [name, body, facets, size] = layout_.sets[set];
    std::vector<int> elements, sides;
    for (const int place : ownFacets(set)) {
      const Facet facet = (*facets)[std::size_t(place)];
      elements.push_back(
          int(layout_.firstCell[std::size_t(body)] + whole_.elements[std::size_t(body)][std::size_t(facet.cell)] + 1));
      sides.push_back(exodusSide(facet.local));
    }
    if (!elements.empty())
      file_.call("a part of the facets of a side", ex_put_partial_set, EX_SIDE_SET, int(set) + 1,
                 slice_.firstFacets[set] + 1, std::int64_t(elements.size()), elements.data(), sides.data());
  }

  ExodusFile& file_;
  const ExodusLayout& layout_;
  const ExodusWhole& whole_;
  const ExodusSlice& slice_;
};

} // namespace

void putTime(ExodusFile& file, int number, const ExodusStep& step)
{
  file.call("the time of a step", ex_put_time, number, &step.time);
  Vector globals;
  for (const NamedField& value : step.global)
    globals.push_back(value.values.front());
  if (!globals.empty())
    file.call("the global values", ex_put_var, number, EX_GLOBAL, 1, 1, std::int64_t(globals.size()), globals.data());
}

void beginSlices(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                 const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                 const std::vector<std::string>& infoLines, const ExodusWhole& whole)
{
  const ExodusLayout share = makeLayout(bodies, contactSides);
  const ExodusVariables variables = commonVariables(share, steps);
  ExodusFile file(path);
  defineContent(file, title, layoutOfWhole(share, whole), variables, infoLines);
  for (std::size_t s = 0; s < steps.size(); ++s)
    putTime(file, int(s) + 1, steps[s]);
  file.close();
}

void writeSlice(const std::string& path, const std::vector<ExodusBody>& bodies,
                const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                const ExodusWhole& whole, const ExodusSlice& slice)
{
  const ExodusLayout layout = layoutOfWhole(makeLayout(bodies, contactSides), whole);
  ExodusFile file = ExodusFile::opened(path);
  SliceWriter writer(file, layout, whole, slice);
  writer.putMesh();
  for (std::size_t s = 0; s < steps.size(); ++s)
    writer.putStep(int(s) + 1, steps[s]);
  file.close();
}

} // namespace ndframe
