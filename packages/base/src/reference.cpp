#include <fmt/format.h>

#include "ndframe/base/help.hpp"
#include "spec_text.hpp"
#include "spec_view.hpp"

namespace ndframe
{

namespace
{

/// The text as Markdown shows it letter by letter; what stands between backquotes is code already.
std::string markdown(const std::string& text)
{
  std::string escaped;
  bool isCode = false;
  for (const char c : text) {
    isCode = isCode != (c == '`');
    if (c == '|' || (!isCode && std::string("*_<\\").find(c) != std::string::npos))
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string paramTable(const std::vector<ParamSpec>& params, const std::optional<ParamSpec>& each = std::nullopt)
{
  if (params.empty() && !each)
    return {};
  std::string table = "| Parameter | Type | Default | Range | |\n|---|---|---|---|---|\n";
  for (const auto& param : params)
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", param.name, markdown(kindText(param.kind)),
                         markdown(defaultText(param)), markdown(rangeText(param.range)), markdown(param.doc));
  if (each)
    table += fmt::format("| *any name* | {} | | | {} |\n", markdown(kindText(each->kind)), markdown(each->doc));
  return table + "\n";
}

std::string listTable(const std::vector<ListSpec>& lists, const std::shared_ptr<ListSpec>& each)
{
  if (lists.empty() && !each)
    return {};
  std::string table = "| List | | |\n|---|---|---|\n";
  for (const auto& list : lists)
    table += fmt::format("| `{}` | {} | {} |\n", list.name, presence(list), markdown(list.doc));
  if (each)
    table += fmt::format("| *any name* | any number | {} |\n", markdown(each->doc));
  return table + "\n";
}

std::string componentSections(const PlacedList& place)
{
  std::string text;
  if (place.spec->choices)
    for (const auto& component : place.spec->choices->components)
      text += fmt::format("### `{}`, `Type` = `{}`\n\n{}\n\n", place.path, component.name, markdown(component.doc)) +
              paramTable(component.params) + listTable(component.lists, nullptr);
  return text;
}

std::string listSection(const PlacedList& place)
{
  const std::string title = place.path.empty() ? "The deck" : "`" + place.path + "`";
  const std::string owner = place.owner == nullptr ? "" : fmt::format(" (of `{}`)", place.owner->name);
  const std::string handedOn = place.spec->passThrough ? "Its parameters are passed on to the library.\n\n" : "";
  return fmt::format("## {}{}\n\n{}\n\n{}", title, owner, markdown(place.spec->doc), handedOn) +
         paramTable(viewOf(*place.spec, nullptr).params, place.spec->eachParam) +
         listTable(place.spec->lists, place.spec->each) + componentSections(place);
}

} // namespace

std::string referenceMarkdown(const ListSpec& deck)
{
  std::string text = "# Deck reference\n\n"
                     "Written by the program from the specification that checks the decks; do not edit.\n"
                     "`*` in a path stands for a name that the user chooses.\n\n";
  for (const auto& place : allLists(deck))
    text += listSection(place);
  text.pop_back(); // the file ends with one line end
  return text;
}

} // namespace ndframe
