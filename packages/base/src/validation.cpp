#include <algorithm>
#include <stdexcept>
#include <utility>

#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checked_value.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/base/params.hpp"
#include "params_node.hpp"
#include "spec_view.hpp"
#include "text.hpp"
#include "unknown_name.hpp"
#include "value_text.hpp"

namespace ndframe
{

namespace
{

/// How messages call the place of an entry or a list: settings of the command line have no file.
std::string origin(const std::string& file)
{
  return file.empty() ? "--set" : file;
}

template <class Items>
std::vector<std::string> namesOf(const Items& items)
{
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items)
    names.push_back(item.name);
  return names;
}

/// True when a component other than `chosen` has this key or sublist and the chosen one has not.
bool belongsToAnother(const ListSpec& spec, const ComponentInfo* chosen, const std::string& name)
{
  const auto has = [&](const ComponentInfo* component) {
    const SpecView view = viewOf(spec, component);
    return view.findParam(name) != nullptr || view.findList(name) != nullptr;
  };
  const auto& components = spec.choices->components;
  return !has(chosen) && std::any_of(components.begin(), components.end(), [&](const auto& c) { return has(&c); });
}

/// Decks state types, settings do not.
bool isSetting(const DeckEntry& entry)
{
  return entry.type.empty();
}

/// A component chosen with `--set` replaces the deck's: what the deck says of the other one goes with it.
DeckList withoutReplaced(DeckList given, const ListSpec& spec, const ComponentInfo* chosen)
{
  const auto isReplacedEntry = [&](const DeckEntry& entry) {
    return !isSetting(entry) && belongsToAnother(spec, chosen, entry.name);
  };
  const auto isReplacedList = [&](const DeckList& list) {
    return !list.file.empty() && belongsToAnother(spec, chosen, list.name);
  };
  given.entries.erase(std::remove_if(given.entries.begin(), given.entries.end(), isReplacedEntry), given.entries.end());
  given.lists.erase(std::remove_if(given.lists.begin(), given.lists.end(), isReplacedList), given.lists.end());
  return given;
}

bool isReplacedBySetting(const DeckList& given, const ListSpec& spec)
{
  const DeckEntry* type = spec.choices ? given.findEntry("Type") : nullptr;
  return type != nullptr && isSetting(*type);
}

/// True for a list that settings alone have made.
bool isMadeBySettings(const DeckList& list)
{
  return std::all_of(list.entries.begin(), list.entries.end(), isSetting) &&
         std::all_of(list.lists.begin(), list.lists.end(), isMadeBySettings) &&
         !(list.entries.empty() && list.lists.empty());
}

/// Walks deck and specification together and collects what does not fit.
class Validator
{
public:
  explicit Validator(const ListSpec& root) : root_(root) {}

  std::shared_ptr<const Params::Node> list(const DeckList& given, const ListSpec& spec, const std::string& path)
  {
    const ComponentInfo* component = chosenComponent(given, spec);
    if (component != nullptr && isReplacedBySetting(given, spec))
      return list(withoutReplaced(given, spec, component), spec, component, path);
    return list(given, spec, component, path);
  }

  /// In the order of the lines, as a user reads the deck.
  std::vector<Diagnostic> sorted() const
  {
    auto list = diagnostics_.list();
    std::stable_sort(list.begin(), list.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
    return list;
  }

private:
  std::shared_ptr<const Params::Node> list(const DeckList& given, const ListSpec& spec, const ComponentInfo* component,
                                           const std::string& path)
  {
    const ListContext context{root_, spec, component, viewOf(spec, component)};
    auto node = std::make_shared<Params::Node>();
    node->name = given.name;
    node->path = path;
    node->file = origin(given.file);
    node->line = given.line;
    checkNames(given, context, path);
    for (const auto& param : context.view.params)
      addEntry(*node, given, param, context.view);
    if (spec.eachParam)
      for (const auto& named : given.entries)
        if (context.view.findParam(named.name) == nullptr)
          addGiven(*node, named, [&] { return std::pair(spec.eachParam->kind, checkedValue(named, *spec.eachParam)); });
    for (const auto* sublist : context.view.lists)
      addList(*node, given, *sublist, context.view);
    if (spec.each)
      for (const auto& named : given.lists)
        if (context.view.findList(named.name) == nullptr)
          node->lists.push_back(namedList(named, given, *spec.each, path));
    return node;
  }

  /// A list with a name of the user's. One that settings make and that lacks something was often meant to be another.
  std::shared_ptr<const Params::Node> namedList(const DeckList& named, const DeckList& siblings, const ListSpec& spec,
                                                const std::string& path)
  {
    const Diagnostics before = std::exchange(diagnostics_, {});
    auto node = list(named, spec, joinPath(path, named.name));
    const Diagnostics found = std::exchange(diagnostics_, before);
    std::vector<std::string> names;
    for (const auto& sibling : siblings.lists)
      if (!isMadeBySettings(sibling))
        names.push_back(sibling.name);
    if (found.empty() || names.empty() || !isMadeBySettings(named)) {
      diagnostics_.append(found);
      return node;
    }
    const std::string near = nearestName(named.name, names);
    const std::string refusal = fmt::format("{} is not in the deck", inQuotes(named.name));
    if (!near.empty()) {
      mistake(named.file, named.line, path, refusal + "; did you mean " + inQuotes(near) + "?");
      return node;
    }
    mistake(named.file, named.line, path,
            refusal + fmt::format(" ({}), and lacks something to be a new one:", fmt::join(names, ", ")));
    diagnostics_.append(found);
    return node;
  }

  void mistake(const std::string& file, int line, const std::string& path, std::string message)
  {
    if (!message.empty())
      diagnostics_.add({origin(file), line, path, std::move(message)});
  }

  static const ComponentInfo* chosenComponent(const DeckList& given, const ListSpec& spec)
  {
    if (!spec.choices)
      return nullptr;
    const DeckEntry* type = given.findEntry("Type");
    return findComponent(spec, type != nullptr ? type->value : spec.choices->defaultType);
  }

  void checkNames(const DeckList& given, const ListContext& context, const std::string& path)
  {
    for (const auto& entry : given.entries)
      if (!context.spec.eachParam && context.view.findParam(entry.name) == nullptr)
        mistake(entry.file, entry.line, path, unknownKeyMessage(context, entry.name));
    if (context.spec.each)
      return;
    for (const auto& sublist : given.lists)
      if (context.view.findList(sublist.name) == nullptr)
        mistake(sublist.file, sublist.line, path, unknownListMessage(context, sublist.name));
  }

  void addEntry(Params::Node& node, const DeckList& given, const ParamSpec& spec, const SpecView& view)
  {
    const DeckEntry* entry = given.findEntry(spec.name);
    if (entry != nullptr)
      addGiven(node, *entry, [&] { return std::pair(spec.kind, checkedValue(*entry, spec)); });
    else if (spec.defaultValue)
      node.entries.push_back({spec.name, spec.kind, *spec.defaultValue, false, node.file, node.line});
    else if (spec.isRequired && !isMisspelt(namesOf(given.entries), view.paramNames(), spec.name))
      mistake(given.file, given.line, node.path, missingMessage(spec));
  }

  /// `typedValue` gives kind and value, or throws std::invalid_argument with what is wrong with the entry.
  template <class TypedValue>
  void addGiven(Params::Node& node, const DeckEntry& entry, TypedValue typedValue)
  {
    try {
      auto [kind, value] = typedValue();
      node.entries.push_back({entry.name, kind, std::move(value), true, origin(entry.file), entry.line});
    } catch (const std::invalid_argument& error) {
      mistake(entry.file, entry.line, node.path, error.what());
    }
  }

  static bool isExcused(const ListSpec& spec, const DeckList& parent)
  {
    return std::any_of(spec.requiredUnless.begin(), spec.requiredUnless.end(),
                       [&](const std::string& name) { return parent.findList(name) != nullptr; });
  }

  void addList(Params::Node& node, const DeckList& parent, const ListSpec& spec, const SpecView& view)
  {
    const DeckList* given = parent.findList(spec.name);
    const std::string path = joinPath(node.path, spec.name);
    if (given == nullptr && spec.isRequired && !isExcused(spec, parent) &&
        !isMisspelt(namesOf(parent.lists), view.listNames(), spec.name))
      mistake(parent.file, parent.line, node.path, fmt::format("the list {} is missing.", inQuotes(spec.name)));
    if (given == nullptr && (spec.isRequired || spec.onlyIfGiven))
      return;
    if (spec.passThrough)
      node.lists.push_back(passThroughList(given, parent, spec, path));
    else
      node.lists.push_back(
          list(given != nullptr ? *given : DeckList{spec.name, parent.file, parent.line, {}, {}}, spec, path));
  }

  std::shared_ptr<const Params::Node> passThroughList(const DeckList* given, const DeckList& parent,
                                                      const ListSpec& spec, const std::string& path)
  {
    if (given == nullptr)
      return asWritten({spec.name, parent.file, parent.line, {}, {}}, path);
    auto node = asWritten(*given, path);
    for (const auto& message : spec.passThrough(toTeuchos(*node)))
      mistake(given->file, given->line, path, message);
    return node;
  }

  /// A list that no spec describes: the types are those that the deck states, or what a setting looks like.
  std::shared_ptr<const Params::Node> asWritten(const DeckList& given, const std::string& path)
  {
    auto node = std::make_shared<Params::Node>();
    node->name = given.name;
    node->path = path;
    node->file = origin(given.file);
    node->line = given.line;
    for (const auto& entry : given.entries)
      addGiven(*node, entry, [&] {
        Value value = statedValue(entry);
        return std::pair(kindOf(value), std::move(value));
      });
    for (const auto& sublist : given.lists)
      node->lists.push_back(asWritten(sublist, joinPath(path, sublist.name)));
    return node;
  }

  const ListSpec& root_;
  Diagnostics diagnostics_;
};

} // namespace

Params validate(const DeckList& deck, const ListSpec& spec, Diagnostics& diagnostics)
{
  Validator validator(spec);
  Params params(validator.list(deck, spec, {}));
  for (auto& diagnostic : validator.sorted())
    diagnostics.add(std::move(diagnostic));
  return params;
}

} // namespace ndframe
