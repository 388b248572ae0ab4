#include "unknown_name.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/help.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

/// What differs between the messages for keys and for sublists.
struct Wording
{
  std::string noun;                                        ///< "parameter"
  std::vector<std::string> (*names)(const SpecView&);      ///< of this sort
  std::vector<std::string> (*otherNames)(const SpecView&); ///< of the other sort
  std::string other;                                       ///< what to write when it is of the other sort
};

std::vector<std::string> paramNames(const SpecView& view)
{
  return view.paramNames();
}
std::vector<std::string> listNames(const SpecView& view)
{
  return view.listNames();
}

const Wording keys{"parameter", paramNames, listNames, "a list here: write <ParameterList name="};
const Wording sublists{"list", listNames, paramNames, "a parameter here: write <Parameter name="};

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> componentsWith(const ListContext& context, const Wording& wording, const std::string& name)
{
  std::vector<std::string> owners;
  if (context.spec.choices)
    for (const auto& component : context.spec.choices->components)
      if (contains(wording.names(viewOf(context.spec, &component)), name))
        owners.push_back(component.name);
  return owners;
}

/// Paths of the other lists that have this name.
std::vector<std::string> placesOf(const ListContext& context, const Wording& wording, const std::string& name)
{
  std::vector<std::string> paths;
  const auto add = [&](const PlacedList& place, const SpecView& view) {
    const std::string path = place.path.empty() ? "the outer list" : place.path;
    if (place.spec != &context.spec && contains(wording.names(view), name) && !contains(paths, path))
      paths.push_back(path);
  };
  for (const auto& place : allLists(context.root)) {
    add(place, viewOf(*place.spec, nullptr));
    if (place.spec->choices)
      for (const auto& component : place.spec->choices->components)
        add(place, viewOf(*place.spec, &component));
  }
  return paths;
}

std::string validNames(const ListContext& context, const Wording& wording)
{
  const auto names = wording.names(context.view);
  if (names.empty())
    return context.spec.each ? "it takes lists that you name." : fmt::format("it takes no {}s.", wording.noun);
  return fmt::format("valid names: {}.", fmt::join(names, ", "));
}

std::string message(const ListContext& context, const Wording& wording, const std::string& name)
{
  constexpr std::size_t fewPlaces = 3; // more of them would not help to find the right one
  if (contains(wording.otherNames(context.view), name))
    return fmt::format("{} is {}{} .../>.", inQuotes(name), wording.other, inQuotes(name));
  const auto owners = componentsWith(context, wording, name);
  if (!owners.empty() && context.component == nullptr)
    return {};
  if (!owners.empty())
    return fmt::format("{} is not a {} of {} (it belongs to {}).", inQuotes(name), wording.noun,
                       context.component->name, fmt::join(owners, ", "));
  const std::string refusal = fmt::format("{} is not a {} here; ", inQuotes(name), wording.noun);
  const std::string near = nearestName(name, wording.names(context.view));
  if (!near.empty())
    return refusal + "did you mean " + inQuotes(near) + "?";
  if (const std::string limit = limitOf(name); !limit.empty())
    return fmt::format("{} is {} docs/limits.md lists what else is not.", inQuotes(name), limit);
  const auto places = placesOf(context, wording, name);
  if (!places.empty() && places.size() <= fewPlaces)
    return refusal + fmt::format("it belongs to {}.", fmt::join(places, ", "));
  return refusal + validNames(context, wording);
}

} // namespace

std::string unknownKeyMessage(const ListContext& context, const std::string& key)
{
  return message(context, keys, key);
}

bool isMisspelt(const std::vector<std::string>& given, const std::vector<std::string>& valid, const std::string& name)
{
  return std::any_of(given.begin(), given.end(), [&](const std::string& written) {
    return !contains(valid, written) && nearestName(written, valid) == name;
  });
}

std::string unknownListMessage(const ListContext& context, const std::string& list)
{
  return message(context, sublists, list);
}

} // namespace ndframe
