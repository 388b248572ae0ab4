#include "ndframe/base/changed_params.hpp"

#include "params_node.hpp"
#include "value_text.hpp"

namespace ndframe
{
namespace
{

std::shared_ptr<const Params::Node> given(const Params::Node& node)
{
  auto kept = std::make_shared<Params::Node>(node);
  kept->entries.clear();
  for (const auto& entry : node.entries)
    if (entry.isGiven)
      kept->entries.push_back(entry);
  for (auto& list : kept->lists)
    list = given(*list);
  return kept;
}

} // namespace

std::vector<DeckEntry> givenEntries(const Params& list)
{
  std::vector<DeckEntry> entries;
  for (const auto& entry : list.node().entries)
    if (entry.isGiven)
      entries.push_back({entry.name, kindName(kindOf(entry.value)), valueText(entry.value), entry.file, entry.line});
  return entries;
}

Params withoutDefaults(const Params& list)
{
  return Params(given(list.node()));
}

Params withSublists(const Params& lists, const std::string& name, const std::vector<Params>& sublists)
{
  auto changed = std::make_shared<Params::Node>(lists.node());
  for (auto& list : changed->lists) {
    if (list->name != name)
      continue;
    auto other = std::make_shared<Params::Node>(*list);
    other->lists.clear();
    for (const Params& sublist : sublists)
      other->lists.push_back(std::make_shared<const Params::Node>(sublist.node()));
    list = std::move(other);
  }
  return Params(std::move(changed));
}

} // namespace ndframe
