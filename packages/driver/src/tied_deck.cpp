#include "ndframe/driver/tied_deck.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{
namespace
{

std::string inPart(const std::string& part, const std::string& name)
{
  return part + ": " + name;
}

DeckList named(std::string name, const DeckList& place)
{
  return {std::move(name), place.file, place.line, {}, {}};
}

DeckEntry entry(const std::string& name, const std::string& value, const DeckList& place)
{
  return {name, "string", value, place.file, place.line};
}

DeckEntry groupsEntry(const std::vector<std::string>& groups, const DeckList& place)
{
  return {"Cells", "Array(string)", fmt::format("{{{}}}", fmt::join(groups, ", ")), place.file, place.line};
}

DeckList renamed(DeckList list, std::string name)
{
  list.name = std::move(name);
  return list;
}

DeckList& listIn(DeckList& parent, const std::string& name)
{
  const auto found =
      std::find_if(parent.lists.begin(), parent.lists.end(), [&](const DeckList& list) { return list.name == name; });
  if (found != parent.lists.end())
    return *found;
  parent.lists.push_back(named(name, parent));
  return parent.lists.back();
}

/// Which bodies tied interfaces join.
class TiedBodies
{
public:
  TiedBodies(const Params& deck, Diagnostics& diagnostics)
  {
    for (const Params& body : deck.sub("Bodies").subs())
      names_.push_back(body.name());
    for (const Params& interface : deck.sub("Interfaces").subs())
      if (interface.has("Tied") && interface.get<bool>("Tied")) // Automatic ties nothing
        add(deck, interface, diagnostics);
  }

  bool any() const { return !tied_.empty(); }
  bool isTied(const std::string& interface) const { return tied_.count(interface) > 0; }

  /// The bodies that are one with this one, in the deck's order.
  std::vector<std::string> partsOf(const std::string& body) const
  {
    std::vector<std::string> parts;
    for (const std::string& name : names_)
      if (root(name) == root(body))
        parts.push_back(name);
    return parts;
  }
  std::string nameOf(const std::string& body) const { return fmt::format("{}", fmt::join(partsOf(body), " + ")); }
  bool isPart(const std::string& body) const { return partsOf(body).size() > 1; }

private:
  void add(const Params& deck, const Params& interface, Diagnostics& diagnostics)
  {
    for (const char* key : {"Gap", "Gap From Geometry"})
      if (interface.isGiven(key))
        diagnostics.add(interface.mistake(key, "has no meaning where sides are tied; remove it, or Tied."));
    if (interface.sub("Pairing").isGiven("Type"))
      diagnostics.add(interface.sub("Pairing").mistake("Type", "has no meaning where sides are tied; remove it."));
    std::vector<std::string> bodies;
    for (const char* key : {"Dirichlet Body", "Neumann Body"}) {
      const auto name = interface.get<std::string>(key);
      if (std::find(names_.begin(), names_.end(), name) == names_.end())
        diagnostics.add(interface.mistake(
            key, fmt::format("there is no body \"{}\"; the bodies are: {}.", name, fmt::join(names_, ", "))));
      else if (deck.sub("Bodies").sub(name).hasSub("Rigid"))
        diagnostics.add(interface.mistake(key, fmt::format("\"{}\" is rigid: nothing can be tied to it; clamp the side "
                                                           "instead.",
                                                           name)));
      bodies.push_back(name);
    }
    if (!interface.has("Neumann Side"))
      diagnostics.add(interface.mistake("Neumann Side", "the key \"Neumann Side\" is missing."));
    tied_.insert(interface.name());
    parent_[root(bodies[1])] = root(bodies[0]);
  }

  std::string root(std::string name) const
  {
    for (auto found = parent_.find(name); found != parent_.end() && found->second != name; found = parent_.find(name))
      name = found->second;
    return name;
  }

  std::vector<std::string> names_;
  std::set<std::string> tied_;
  std::map<std::string, std::string> parent_;
};

/// Writes the deck in which tied bodies are one.
class TiedDeck
{
public:
  TiedDeck(const DeckList& deck, const Params& params, const TiedBodies& tied, Diagnostics& diagnostics)
      : deck_(deck), params_(params), tied_(tied), diagnostics_(diagnostics)
  {}

  DeckList write() const
  {
    DeckList result = deck_;
    DeckList& bodies = listIn(result, "Bodies");
    bodies.lists.clear();
    for (const DeckList& body : deck_.findList("Bodies")->lists)
      if (!tied_.isPart(body.name))
        bodies.lists.push_back(body);
      else if (tied_.partsOf(body.name).front() == body.name)
        bodies.lists.push_back(whole(body));
    DeckList& interfaces = listIn(result, "Interfaces");
    interfaces.lists.clear();
    for (const DeckList& interface : deck_.findList("Interfaces")->lists)
      if (!tied_.isTied(interface.name))
        interfaces.lists.push_back(between(interface));
    return result;
  }

private:
  const DeckList& bodyList(const std::string& name) const { return *deck_.findList("Bodies")->findList(name); }

  DeckList whole(const DeckList& first) const
  {
    DeckList body = named(tied_.nameOf(first.name), first);
    body.lists.push_back(mesh(first));
    for (const std::string& part : tied_.partsOf(first.name)) {
      addMaterials(body, bodyList(part));
      addConditions(body, bodyList(part), "Supports");
      addConditions(body, bodyList(part), "Loads");
    }
    return body;
  }

  DeckList mesh(const DeckList& first) const
  {
    DeckList mesh = named("Mesh", first);
    mesh.entries.push_back(entry("Type", "Tied", first));
    DeckList parts = named("Parts", first), joints = named("Joints", first);
    for (const std::string& part : tied_.partsOf(first.name))
      parts.lists.push_back(renamed(*bodyList(part).findList("Mesh"), part));
    for (const DeckList& interface : deck_.findList("Interfaces")->lists) {
      const Params given = params_.sub("Interfaces").sub(interface.name);
      if (!tied_.isTied(interface.name) ||
          tied_.nameOf(given.get<std::string>("Dirichlet Body")) != tied_.nameOf(first.name))
        continue;
      DeckList joint = named(interface.name, interface);
      for (const auto& [key, as] :
           {std::pair("Dirichlet Body", "First Part"), std::pair("Dirichlet Side", "First Side"),
            std::pair("Neumann Body", "Second Part"), std::pair("Neumann Side", "Second Side"),
            std::pair("Corner Angle", "Corner Angle")})
        if (const DeckEntry* found = interface.findEntry(key)) {
          joint.entries.push_back(*found);
          joint.entries.back().name = as;
        }
      joints.lists.push_back(std::move(joint));
    }
    mesh.lists = {std::move(parts), std::move(joints)};
    return mesh;
  }

  /// Regions of the whole: the part's own, or the part.
  void addMaterials(DeckList& whole, const DeckList& part) const
  {
    const DeckList *material = part.findList("Material"), *regions = part.findList("Regions");
    DeckList& all = listIn(whole, "Regions");
    if (regions == nullptr) {
      DeckList region = named(part.name, part);
      region.entries.push_back(groupsEntry({part.name}, part));
      region.lists.push_back(*material);
      all.lists.push_back(std::move(region));
      return;
    }
    for (const DeckList& region : regions->lists) {
      const Params given = params_.sub("Bodies").sub(part.name).sub("Regions").sub(region.name);
      DeckList own = renamed(region, inPart(part.name, region.name));
      own.entries = {
          groupsEntry(inPartAll(part.name, given.get<std::vector<std::string>>("Cells"), region.name), region)};
      all.lists.push_back(std::move(own));
    }
    if (material == nullptr)
      return;
    if (whole.findList("Material") != nullptr)
      diagnostics_.add(params_.sub("Bodies")
                           .sub(part.name)
                           .sub("Material")
                           .mistake("", "only one of the tied bodies may have both Regions and a Material for the "
                                        "rest; name the rest of this one as a region."));
    whole.lists.push_back(*material);
  }

  static std::vector<std::string> inPartAll(const std::string& part, std::vector<std::string> groups,
                                            const std::string& otherwise)
  {
    if (groups.empty())
      groups = {otherwise};
    for (std::string& group : groups)
      group = inPart(part, group);
    return groups;
  }

  /// Supports or loads of a part, on its sides and in its cells.
  void addConditions(DeckList& whole, const DeckList& part, const char* kind) const
  {
    const DeckList* conditions = part.findList(kind);
    if (conditions == nullptr)
      return;
    DeckList& all = listIn(whole, kind);
    for (const DeckList& condition : conditions->lists) {
      const Params given = params_.sub("Bodies").sub(part.name).sub(kind).sub(condition.name);
      DeckList own = renamed(condition, inPart(part.name, condition.name));
      for (DeckEntry& entry : own.entries)
        if (entry.name == "Side")
          entry.value = inPart(part.name, entry.value);
      if (given.has("Cells")) {
        const auto groups = given.get<std::vector<std::string>>("Cells");
        own.entries.erase(std::remove_if(own.entries.begin(), own.entries.end(),
                                         [](const DeckEntry& entry) { return entry.name == "Cells"; }),
                          own.entries.end());
        own.entries.push_back(groupsEntry(
            groups.empty() ? std::vector<std::string>{part.name} : inPartAll(part.name, groups, {}), condition));
      }
      all.lists.push_back(std::move(own));
    }
  }

  /// An interface that is not tied, between the wholes.
  DeckList between(DeckList interface) const
  {
    const Params given = params_.sub("Interfaces").sub(interface.name);
    for (const char* role : {"Dirichlet", "Neumann"}) {
      const std::string bodyKey = std::string(role) + " Body", sideKey = std::string(role) + " Side";
      if (!given.has(bodyKey) || !tied_.isPart(given.get<std::string>(bodyKey)))
        continue;
      const auto body = given.get<std::string>(bodyKey);
      for (DeckEntry& entry : interface.entries) {
        if (entry.name == bodyKey)
          entry.value = tied_.nameOf(body);
        if (entry.name == sideKey)
          entry.value = inPart(body, entry.value);
      }
    }
    return interface;
  }

  const DeckList& deck_;
  const Params& params_;
  const TiedBodies& tied_;
  Diagnostics& diagnostics_;
};

} // namespace

Params validateScene(const DeckList& deck, const ListSpec& spec, Diagnostics& diagnostics)
{
  Diagnostics own;
  Params params = validate(deck, spec, own);
  if (own.empty()) {
    const TiedBodies tied(params, own);
    if (own.empty() && tied.any()) {
      const DeckList whole = TiedDeck(deck, params, tied, own).write();
      if (own.empty())
        params = validate(whole, spec, own);
    }
  }
  diagnostics.append(own);
  return params;
}

} // namespace ndframe
