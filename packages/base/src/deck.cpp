#include "ndframe/base/deck.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "text.hpp"

namespace ndframe
{

namespace
{

/// Far more than any deck needs (meshes are files of their own); a larger file is a mistaken path.
constexpr std::size_t maxDeckBytes = std::size_t(4) << 20;

/// As many levels as the XML parser reads; lists are walked by recursion.
constexpr std::size_t maxDepth = 100;

template <class Items>
auto* findByName(Items& items, const std::string& name)
{
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

std::string readText(const std::string& path)
{
  const auto refuse = [&](const std::string& message) { throw InputError(Diagnostic{path, 0, {}, message}); };
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status))
    refuse("is a directory, not a deck.");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    refuse("is not a regular file."); // a pipe could wait for ever
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    refuse(fmt::format("cannot be opened: {}.", std::strerror(errno)));
  std::string text;
  std::string block(std::size_t(1) << 16, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > maxDeckBytes)
      refuse(fmt::format("is larger than {} MB, which no deck needs.", maxDeckBytes >> 20));
  }
  if (file.bad())
    refuse(fmt::format("cannot be read: {}.", std::strerror(errno)));
  return text;
}

Diagnostic wrongSetting(const std::string& file, int line, const std::string& setting, const std::string& reason)
{
  return {file, line, {}, fmt::format("{} {}; write \"List/Sublist/Key=value\".", inQuotes(setting), reason)};
}

/// The list at `path` below `deck`; lists that do not exist are created where the setting stands.
DeckList& listAt(DeckList& deck, const std::vector<std::string>& path, const Setting& setting)
{
  DeckList* list = &deck;
  for (const auto& name : path) {
    auto* next = findByName(list->lists, name);
    if (next == nullptr) {
      list->lists.push_back({name, setting.file, setting.line, {}, {}});
      next = &list->lists.back();
    }
    list = next;
  }
  return *list;
}

} // namespace

const DeckEntry* DeckList::findEntry(const std::string& entryName) const
{
  return findByName(entries, entryName);
}

const DeckList* DeckList::findList(const std::string& listName) const
{
  return findByName(lists, listName);
}

DeckList readDeck(const std::string& path)
{
  return parseDeck(readText(path), path);
}

void applySetting(DeckList& deck, const Setting& setting, Diagnostics& diagnostics)
{
  const auto refuse = [&](const std::string& reason) {
    diagnostics.add(wrongSetting(setting.file.empty() ? "--set" : setting.file, setting.line,
                                 setting.path + "=" + setting.value, reason));
  };
  std::vector<std::string> path;
  for (const auto& part : split(setting.path, "/"))
    path.emplace_back(trimmed(part));
  if (std::any_of(path.begin(), path.end(), [](const std::string& part) { return part.empty(); }))
    return refuse("has an empty name before the \"=\"");
  if (path.size() > maxDepth)
    return refuse("is nested too deeply");
  const std::string key = path.back();
  path.pop_back();
  DeckList& list = listAt(deck, path, setting);
  const DeckEntry entry{key, {}, setting.value, setting.file, setting.line};
  if (auto* existing = findByName(list.entries, key))
    *existing = entry;
  else
    list.entries.push_back(entry);
}

void applySetting(DeckList& deck, const std::string& setting, Diagnostics& diagnostics)
{
  const auto refuse = [&](const std::string& reason) { diagnostics.add(wrongSetting("--set", 0, setting, reason)); };
  if (findInvalidByte(setting))
    return refuse("is not plain UTF-8 text");
  const auto equals = setting.find('=');
  if (equals == std::string::npos)
    return refuse("has no \"=\"");
  applySetting(deck, Setting{setting.substr(0, equals), setting.substr(equals + 1), {}, 0}, diagnostics);
}

} // namespace ndframe
