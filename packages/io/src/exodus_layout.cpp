#include "exodus_layout.hpp"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <stdexcept>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

void appendCount(std::vector<int>& first, std::int64_t count)
{
  const std::int64_t next = first.back() + count;
  if (next > INT_MAX)
    throw std::runtime_error("an Exodus file with 32-bit numbers holds at most 2147483647 nodes or elements");
  first.push_back(int(next));
}

std::vector<std::string> namesOf(const std::vector<NamedField>& fields)
{
  std::vector<std::string> names;
  for (const auto& field : fields)
    names.push_back(field.name);
  return names;
}

std::vector<std::string> namesOfFirst(const std::vector<std::vector<NamedField>>& parts)
{
  return parts.empty() ? std::vector<std::string>{} : namesOf(parts.front());
}

/// `size(part)`: number of nodes, cells or facets of a body or a contact side.
template <class Size>
void checkFields(const std::vector<std::vector<NamedField>>& parts, const std::vector<std::string>& names,
                 std::size_t numParts, Size size)
{
  NDFRAME_ASSERT(parts.size() == numParts, "a step has fields for every body and every contact side");
  for (std::size_t part = 0; part < numParts; ++part) {
    NDFRAME_ASSERT(namesOf(parts[part]) == names, "all bodies, contact sides and steps have the same variables");
    for (const auto& field : parts[part])
      NDFRAME_ASSERT(field.values.size() == std::size_t(size(part)), "wrong number of values in field " + field.name);
  }
}

void checkStep(const ExodusLayout& layout, const ExodusVariables& variables, const ExodusStep& step)
{
  const auto& bodies = *layout.bodies;
  checkFields(step.nodal, variables.nodal, bodies.size(), [&](std::size_t b) { return bodies[b].nodes->numNodes(); });
  checkFields(step.element, variables.element, bodies.size(),
              [&](std::size_t b) { return bodies[b].nodes->numCells(); });
  checkFields(step.contactSide, variables.contactSide, layout.sets.size() - layout.firstContact,
              [&](std::size_t s) { return layout.sets[layout.firstContact + s].facets->size(); });
  checkFields({step.global}, variables.global, 1, [](std::size_t) { return 1; });
}

/// firstCell of the body is there.
void addBlocks(const ExodusBody& body, int number, ExodusLayout& layout)
{
  int first = layout.firstCell[std::size_t(number)];
  layout.elements.emplace_back();
  if (body.parts.empty())
    layout.blocks.push_back({body.name, number, nullptr, first, body.nodes->numCells()});
  else
    layout.elements.back().assign(std::size_t(body.nodes->numCells()), -1);
  for (const ExodusPart& part : body.parts) {
    layout.blocks.push_back({part.name, number, &part.cells, first, int(part.cells.size())});
    for (const int cell : part.cells)
      layout.elements.back()[std::size_t(cell)] = first++;
  }
  NDFRAME_ASSERT(body.parts.empty() || first == layout.firstCell[std::size_t(number) + 1],
                 "every cell of a body is in one part: " + body.name);
}

} // namespace

void ExodusLayout::appendBody(std::int64_t numNodes, std::int64_t numCells)
{
  appendCount(firstNode, numNodes);
  appendCount(firstCell, numCells);
}

ExodusLayout makeLayout(const std::vector<ExodusBody>& bodies, const std::vector<ExodusContactSide>& contactSides)
{
  NDFRAME_ASSERT(!bodies.empty(), "an Exodus file has at least one body");
  ExodusLayout layout;
  layout.bodies = &bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [name, mesh, nodes, parts] = bodies[b];
    NDFRAME_ASSERT(mesh != nullptr && nodes != nullptr, "body without mesh or nodes: " + name);
    NDFRAME_ASSERT(nodes->dim == bodies.front().nodes->dim, "bodies of one file have the same dimension");
    layout.appendBody(nodes->numNodes(), nodes->numCells());
    addBlocks(bodies[b], int(b), layout);
    for (const auto& side : mesh->sides)
      layout.sets.push_back(
          {name.empty() ? side.name : name + ":" + side.name, int(b), &side.facets, std::int64_t(side.facets.size())});
  }
  layout.firstContact = layout.sets.size();
  for (const auto& side : contactSides)
    layout.sets.push_back({side.name, side.body, &side.facets, std::int64_t(side.facets.size())});
  return layout;
}

ExodusVariables commonVariables(const ExodusLayout& layout, const std::vector<ExodusStep>& steps)
{
  if (steps.empty())
    return {};
  const auto& first = steps.front();
  ExodusVariables variables{namesOfFirst(first.nodal), namesOfFirst(first.element), namesOfFirst(first.contactSide),
                            namesOf(first.global)};
  for (const auto& step : steps)
    checkStep(layout, variables, step);
  return variables;
}

std::size_t longestName(const ExodusLayout& layout, const ExodusVariables& variables)
{
  std::size_t longest = 1;
  for (const auto& block : layout.blocks)
    longest = std::max(longest, block.name.size());
  for (const auto& set : layout.sets)
    longest = std::max(longest, set.name.size());
  for (const auto* names : {&variables.nodal, &variables.element, &variables.contactSide, &variables.global})
    for (const auto& name : *names)
      longest = std::max(longest, name.size());
  return longest;
}

} // namespace ndframe
