#include "scaled_data.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{
namespace
{

template <class Items>
auto* named(Items& items, const std::string& name)
{
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

/// The parameters of a list, those of its component included.
std::vector<ParamSpec> paramsOf(const DeckList& list, const ListSpec& spec)
{
  std::vector<ParamSpec> params = spec.params;
  if (!spec.choices)
    return params;
  const DeckEntry* const type = list.findEntry("Type");
  const auto* component = named(spec.choices->components, type == nullptr ? spec.choices->defaultType : type->value);
  if (component != nullptr)
    params.insert(params.end(), component->params.begin(), component->params.end());
  return params;
}

std::vector<std::string> givenExpressions(const DeckList& list, const ListSpec& spec)
{
  std::vector<std::string> keys;
  for (const ParamSpec& param : paramsOf(list, spec))
    if (param.kind == Kind::Expression && list.findEntry(param.name) != nullptr)
      keys.push_back(param.name);
  return keys;
}

const ListSpec& eachOf(const ListSpec& spec, const char* list)
{
  return *named(spec.lists, list)->each;
}

const std::vector<DeckList>& listsIn(const DeckList* list)
{
  static const std::vector<DeckList> none;
  return list == nullptr ? none : list->lists;
}

/// A number; nothing where the text is no number alone.
bool readNumber(const std::string& text, double& value)
{
  const char* const begin = text.c_str();
  char* end = nullptr;
  value = std::strtod(begin, &end);
  while (*end == ' ' || *end == '\t' || *end == '\n')
    ++end;
  return end != begin && *end == '\0';
}

std::string product(double factor, const std::string& text)
{
  double value = 0.0;
  if (factor == 0.0)
    return "0";
  return readNumber(text, value) ? fmt::format("{}", factor * value) : fmt::format("{} * ({})", factor, text);
}

/// Of "{0, -0.1}" each entry.
std::string productOfAll(double factor, const std::string& text)
{
  const auto open = text.find('{'), close = text.rfind('}');
  if (open == std::string::npos || close == std::string::npos)
    return product(factor, text);
  std::vector<std::string> products;
  for (std::size_t begin = open + 1; begin <= close;) {
    const std::size_t end = std::min(text.find(',', begin), close);
    products.push_back(product(factor, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fmt::format("{{{}}}", fmt::join(products, ", "));
}

} // namespace

ScalableData::ScalableData(const DeckList& deck, const ListSpec& spec)
{
  const ListSpec& bodySpec = eachOf(spec, "Bodies");
  for (const DeckList& body : listsIn(deck.findList("Bodies"))) {
    for (const char* group : {"Loads", "Supports"})
      for (const DeckList& list : listsIn(body.findList(group)))
        add({"Bodies", body.name, group, list.name}, givenExpressions(list, eachOf(bodySpec, group)));
    const DeckList* const rigid = body.findList("Rigid");
    if (rigid != nullptr && rigid->findEntry("Displacement") != nullptr)
      add({"Bodies", body.name, "Rigid"}, {"Displacement"});
  }
  for (const DeckList& interface : listsIn(deck.findList("Interfaces")))
    add({"Interfaces", interface.name}, givenExpressions(interface, eachOf(spec, "Interfaces")));
}

void ScalableData::add(std::vector<std::string> lists, std::vector<std::string> keys)
{
  const std::string path = fmt::format("{}", fmt::join(lists, "/"));
  if (!keys.empty())
    places_[path] = {std::move(lists), std::move(keys)};
}

std::vector<std::string> ScalableData::paths() const
{
  std::vector<std::string> paths;
  for (const auto& [path, place] : places_)
    paths.push_back(path);
  return paths;
}

void ScalableData::multiply(DeckList& deck, const std::string& path, double factor) const
{
  const Place& place = places_.at(path);
  DeckList* list = &deck;
  for (const std::string& name : place.lists)
    list = named(list->lists, name);
  if (factor == 1.0)
    return;
  for (const std::string& key : place.keys) {
    DeckEntry& entry = *named(list->entries, key);
    entry.value = productOfAll(factor, entry.value);
    entry.type.clear(); // another one may be right now
  }
}

} // namespace ndframe
