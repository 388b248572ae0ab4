#include "ndframe/base/help.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "help_search.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "spec_text.hpp"
#include "spec_view.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

/// Stands for the path of what has none; no word is the same.
const std::string noPath = "//";

std::string paramsText(const std::vector<ParamSpec>& params, std::size_t indent)
{
  std::string text;
  for (const auto& param : params)
    text += fmt::format("{:{}}{}  ({})\n", "", indent, param.name, fmt::join(paramFacts(param), ", ")) +
            wrapped(param.doc, indent + 2);
  return text;
}

std::string listsText(const std::vector<ListSpec>& lists, std::size_t indent)
{
  std::string text;
  for (const auto& list : lists)
    text += fmt::format("{:{}}{}/  ({})\n", "", indent, list.name, presence(list)) + wrapped(list.doc, indent + 2);
  return text;
}

/// What follows the component's name.
std::string componentBody(const ComponentInfo& component, std::size_t indent)
{
  return wrapped(component.doc, indent) + paramsText(component.params, indent + 2) +
         listsText(component.lists, indent + 2);
}

std::string listText(const PlacedList& place)
{
  const ListSpec& spec = *place.spec;
  std::string text = (place.path.empty() ? "The deck" : place.path) + "\n" + wrapped(spec.doc, 2);
  const auto section = [&](const std::string& title, const std::string& body) {
    if (!body.empty())
      text += fmt::format("\n  {}\n{}", title, body);
  };
  section("Parameters", paramsText(viewOf(spec, nullptr).params, 4));
  section("Lists", listsText(spec.lists, 4));
  if (spec.eachParam)
    section("Parameters that you name", wrapped(spec.eachParam->doc, 4));
  if (spec.each)
    section("Lists that you name", wrapped(spec.each->doc, 4));
  if (spec.passThrough)
    text += "\n  Its parameters are passed on to the library.\n";
  std::string components;
  if (spec.choices)
    for (const auto& component : spec.choices->components)
      components += fmt::format("    {}\n", component.name) + componentBody(component, 6);
  section("Components, chosen by \"Type\"", components);
  return text;
}

/// True when `name` is the path of the list, with "*" standing for any name of the user's.
bool matchesPath(const std::string& path, const std::string& name)
{
  const auto wanted = split(name, "/");
  const auto parts = split(path, "/");
  return std::equal(parts.begin(), parts.end(), wanted.begin(), wanted.end(),
                    [](const std::string& part, const std::string& want) { return part == "*" || part == want; });
}

/// The lists and components whose path and name are wanted. A component goes by its name alone.
template <class Wanted>
std::string namedText(const ListSpec& deck, const Wanted& wanted)
{
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "\n") + part; };
  for (const auto& place : allLists(deck)) {
    if (wanted(place.path, place.spec->name))
      add(listText(place));
    if (!place.spec->choices)
      continue;
    for (const auto& component : place.spec->choices->components)
      if (wanted(noPath, component.name))
        add(fmt::format("{}, Type = {}\n{}", place.path, component.name, componentBody(component, 2)));
  }
  return text;
}

std::string firstSentence(const std::string& doc)
{
  const auto end = doc.find(". ");
  return end == std::string::npos ? doc : doc.substr(0, end + 1);
}

} // namespace

std::string helpText(const ListSpec& deck, const std::string& listName)
{
  std::vector<std::string> known;
  std::string text = namedText(deck, [&](const std::string& path, const std::string& name) {
    known.insert(known.end(), {path, name});
    return (!listName.empty() && name == listName) || matchesPath(path, listName);
  });
  if (text.empty() && !listName.empty())
    text = namedText(deck, [stem = helpStem(listName)](const std::string& path, const std::string& name) {
      return helpStem(name) == stem || helpStem(path) == stem;
    });
  text += text.empty() ? searchHelp(deck, listName) : parametersNamed(deck, listName);
  if (!text.empty())
    return text;
  const auto limits = limitWords();
  known.insert(known.end(), limits.begin(), limits.end());
  const std::string near = nearestName(listName, known);
  throw InputError(fmt::format("there is no list or component {}; {}", inQuotes(listName),
                               near.empty() ? "--help shows the lists, --list the components."
                                            : "did you mean " + inQuotes(near) + "?"));
}

std::string componentList(const ListSpec& deck)
{
  std::string text;
  for (const auto& place : allLists(deck)) {
    if (!place.spec->choices)
      continue;
    const Choices& choices = *place.spec->choices;
    std::size_t width = 0;
    for (const auto& component : choices.components)
      width = std::max(width, component.name.size());
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", place.path);
    for (const auto& component : choices.components)
      text += fmt::format("  {:{}}  {}{}\n", component.name, width, firstSentence(component.doc),
                          component.name == choices.defaultType ? " (default)" : "");
  }
  return text;
}

} // namespace ndframe
