#include "certificate/deck_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe::test
{
namespace
{

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

void write(const DeckList& list, const std::string& indent, std::string& xml)
{
  xml += fmt::format("{}<ParameterList name=\"{}\">\n", indent, list.name);
  for (const auto& entry : list.entries)
    xml += fmt::format("{}  <Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>\n", indent, entry.name, entry.type,
                       escaped(entry.value));
  for (const auto& sub : list.lists)
    write(sub, indent + "  ", xml);
  xml += indent + "</ParameterList>\n";
}

template <class T>
T& named(std::vector<T>& all, const std::string& name)
{
  const auto at = std::find_if(all.begin(), all.end(), [&](const T& one) { return one.name == name; });
  if (at != all.end())
    return *at;
  all.emplace_back();
  all.back().name = name;
  return all.back();
}

} // namespace

void DeckText::put(const std::string& path, const std::string& type, const std::string& value)
{
  DeckList* list = &root_;
  std::size_t start = 0;
  for (auto slash = path.find('/'); slash != std::string::npos; slash = path.find('/', start)) {
    list = &named(list->lists, path.substr(start, slash - start));
    start = slash + 1;
  }
  DeckEntry& entry = named(list->entries, path.substr(start));
  entry.type = type;
  entry.value = value;
}

void DeckText::set(const std::string& path, double value)
{
  put(path, "double", fmt::format("{}", value));
}

void DeckText::set(const std::string& path, int value)
{
  put(path, "int", fmt::format("{}", value));
}

void DeckText::set(const std::string& path, const std::vector<double>& values)
{
  put(path, "Array(double)", fmt::format("{{{}}}", fmt::join(values, ", ")));
}

void DeckText::set(const std::string& path, const std::vector<int>& values)
{
  put(path, "Array(int)", fmt::format("{{{}}}", fmt::join(values, ", ")));
}

void DeckText::set(const std::string& path, const std::vector<std::string>& values)
{
  put(path, "Array(string)", fmt::format("{{{}}}", fmt::join(values, ", ")));
}

std::string DeckText::xml() const
{
  std::string text;
  write(root_, "", text);
  return text;
}

} // namespace ndframe::test
