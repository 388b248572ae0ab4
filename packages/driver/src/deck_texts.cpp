#include "deck_texts.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::vector<std::string> partsOf(const std::string& text, const std::string& separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (auto end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + separator.size();
  }
  parts.push_back(trimmed(text.substr(begin)));
  return parts;
}

std::string plainPath(const std::string& path)
{
  return fmt::format("{}", fmt::join(partsOf(path, "/"), "/"));
}

std::string outputEntry(const DeckList& deck, const std::string& name)
{
  const DeckList* output = deck.findList("Output");
  const DeckEntry* entry = output == nullptr ? nullptr : output->findEntry(name);
  return entry == nullptr ? std::string() : entry->value;
}

std::string fileNameOf(const DeckList& deck, const std::string& deckName)
{
  const std::string name = outputEntry(deck, "Name");
  return name.empty() ? std::filesystem::path(deckName).stem().string() : name;
}

} // namespace ndframe
