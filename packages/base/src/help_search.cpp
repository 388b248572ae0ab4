#include "help_search.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "ndframe/base/help.hpp"
#include "spec_text.hpp"
#include "spec_view.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

constexpr std::size_t mostHits = 12;
constexpr const char* parameter = "parameter";

struct Hit
{
  std::string path, name, what, doc; ///< `what`: "parameter", "list" or "component"
};

bool isPartOfWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// True when a word of the text begins with the stem.
bool hasWord(const std::string& text, const std::string& stem)
{
  for (auto at = text.find(stem); at != std::string::npos; at = text.find(stem, at + 1))
    if (at == 0 || !isPartOfWord(text[at - 1]))
      return true;
  return false;
}

bool hasAll(const std::string& text, const std::vector<std::string>& stems)
{
  const std::string low = lowered(text);
  return std::all_of(stems.begin(), stems.end(), [&](const auto& stem) { return hasWord(low, stem); });
}

/// Everything that has a name and a documentation.
std::vector<Hit> everything(const ListSpec& deck)
{
  std::vector<Hit> all;
  const auto addParams = [&](const std::string& path, const std::vector<ParamSpec>& params) {
    for (const auto& param : params)
      all.push_back({path, param.name, parameter, param.doc});
  };
  for (const auto& place : allLists(deck)) {
    all.push_back({place.path, place.spec->name, "list", place.spec->doc});
    addParams(place.path, place.spec->params);
    if (!place.spec->choices)
      continue;
    for (const auto& component : place.spec->choices->components) {
      all.push_back({place.path, component.name, "component", component.doc});
      addParams(place.path + ", Type = " + component.name, component.params);
    }
  }
  return all;
}

std::vector<std::string> stemsOf(std::string words)
{
  std::replace(words.begin(), words.end(), '/', ' ');
  std::vector<std::string> stems;
  for (const auto& word : split(words, " "))
    if (!word.empty())
      stems.push_back(helpStem(word));
  return stems;
}

/// Lists of materials, meshes and so on stand in several places; one is enough.
bool isNew(const Hit& hit, const std::vector<Hit>& seen)
{
  return std::none_of(seen.begin(), seen.end(),
                      [&](const Hit& other) { return other.name == hit.name && other.doc == hit.doc; });
}

std::string hitText(const Hit& hit)
{
  const std::string place = hit.path.empty() ? "the deck" : hit.path;
  const std::string head = hit.what == "list"
                               ? place + "/"
                               : fmt::format("{}: {}{}", place, hit.what == "component" ? "Type = " : "", hit.name);
  return "  " + head + "\n" + wrapped(hit.doc, 6);
}

} // namespace

std::string helpStem(const std::string& name)
{
  std::string stem = lowered(name);
  const auto endsWith = [&](std::string_view end) {
    return stem.size() > end.size() + 1 && stem.compare(stem.size() - end.size(), end.size(), end) == 0;
  };
  if (endsWith("ies"))
    return stem.replace(stem.size() - 3, 3, "y");
  if (endsWith("s") && !endsWith("ss"))
    stem.pop_back();
  return stem;
}

std::string parametersNamed(const ListSpec& deck, const std::string& name)
{
  const std::string stem = helpStem(name);
  std::string text;
  std::vector<Hit> seen;
  for (const Hit& hit : everything(deck))
    if (hit.what == parameter && helpStem(hit.name) == stem && isNew(hit, seen)) {
      text += hitText(hit);
      seen.push_back(hit);
    }
  return text.empty() ? text : "\nParameters of that name:\n\n" + text;
}

std::string searchHelp(const ListSpec& deck, const std::string& words)
{
  const auto stems = stemsOf(words);
  std::vector<Hit> byName, byText;
  for (const Hit& hit : stems.empty() ? std::vector<Hit>() : everything(deck)) {
    std::vector<Hit>& hits = hasAll(hit.name, stems) ? byName : byText;
    const bool fits = &hits == &byName || hasAll(hit.name + " " + hit.doc, stems);
    if (fits && isNew(hit, hits))
      hits.push_back(hit);
  }
  byName.insert(byName.end(), byText.begin(), byText.end());
  if (byName.empty())
    return {};
  std::string text = fmt::format("{} is named in:\n\n", inQuotes(words));
  for (std::size_t i = 0; i < std::min(mostHits, byName.size()); ++i)
    text += hitText(byName[i]);
  if (byName.size() > mostHits)
    text += fmt::format("  ... and {} more\n", byName.size() - mostHits);
  return text + "\n`ndframe --help PATH` shows a list, as in `ndframe --help Coupling/Stopping`.\n";
}

std::vector<std::string> listAndComponentNames(const ListSpec& deck)
{
  std::vector<std::string> names;
  const std::string any = "*";
  for (const Hit& hit : everything(deck))
    if (hit.what != parameter && !hit.name.empty() && hit.name != any &&
        std::find(names.begin(), names.end(), hit.name) == names.end())
      names.push_back(hit.name);
  return names;
}

std::vector<std::string> parameterPaths(const ListSpec& deck)
{
  std::vector<std::string> paths;
  for (const auto& place : allLists(deck)) {
    if (place.path.find('*') != std::string::npos)
      continue;
    for (const auto& param : viewOf(*place.spec, nullptr).params)
      paths.push_back(joinPath(place.path, param.name));
    for (const auto& component : place.spec->choices ? place.spec->choices->components : std::vector<ComponentInfo>())
      for (const auto& param : component.params)
        paths.push_back(joinPath(place.path, param.name));
  }
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  return paths;
}

} // namespace ndframe
