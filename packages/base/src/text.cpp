#include "text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

namespace ndframe
{

namespace
{

/// The first bytes of UTF-8 sequences with what may follow: the number of further bytes and the limits of the first of
/// them, which exclude overlong forms, surrogates and code points above U+10FFFF (Unicode standard, table 3-7).
struct Utf8Lead
{
  unsigned char first, last;
  std::size_t following;
  unsigned char low, high;
};

constexpr std::array<Utf8Lead, 9> utf8Leads{{{0x09, 0x0A, 0, 0, 0},
                                             {0x0D, 0x0D, 0, 0, 0},
                                             {0x20, 0x7E, 0, 0, 0},
                                             {0xC2, 0xDF, 1, 0x80, 0xBF},
                                             {0xE0, 0xE0, 2, 0xA0, 0xBF},
                                             {0xED, 0xED, 2, 0x80, 0x9F},
                                             {0xE1, 0xEF, 2, 0x80, 0xBF},
                                             {0xF0, 0xF0, 3, 0x90, 0xBF},
                                             {0xF1, 0xF4, 3, 0x80, 0xBF}}};

/// Length of the well-formed character that starts `text`, 0 when there is none.
std::size_t characterLength(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto* lead = std::find_if(utf8Leads.begin(), utf8Leads.end(),
                                  [&](const Utf8Lead& l) { return l.first <= byte(0) && byte(0) <= l.last; });
  if (lead == utf8Leads.end() || text.size() <= lead->following)
    return 0;
  for (std::size_t i = 1; i <= lead->following; ++i) {
    const unsigned char low = i == 1 ? lead->low : 0x80;
    const unsigned char high = byte(0) == 0xF4 && i == 1 ? 0x8F : i == 1 ? lead->high : 0xBF;
    if (byte(i) < low || byte(i) > high)
      return 0;
  }
  return lead->following + 1;
}

} // namespace

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view space = " \t\r\n";
  const auto first = text.find_first_not_of(space);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(space) - first + 1);
}

std::vector<std::string> split(std::string_view text, std::string_view separator)
{
  std::vector<std::string> parts;
  for (auto at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
    parts.emplace_back(text.substr(0, at));
    text.remove_prefix(at + separator.size());
  }
  parts.emplace_back(text);
  return parts;
}

std::optional<std::size_t> findInvalidByte(std::string_view text)
{
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = characterLength(text.substr(at));
    if (length == 0)
      return at;
    at += length;
  }
  return std::nullopt;
}

std::string inQuotes(std::string_view text)
{
  constexpr std::size_t longest = 80;
  if (text.size() <= longest)
    return fmt::format("\"{}\"", text);
  std::size_t cut = 0; // between characters, not inside one
  while (cut < longest)
    cut += std::max<std::size_t>(1, characterLength(text.substr(cut)));
  return fmt::format("\"{}...\"", text.substr(0, cut));
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width)
{
  std::string lines;
  std::string line;
  const auto flush = [&] {
    if (!line.empty())
      lines += std::string(indent, ' ') + line + '\n';
    line.clear();
  };
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (indent + line.size() + 1 + word.size() > width)
      flush();
    line += line.empty() ? word : ' ' + word;
  }
  flush();
  return lines;
}

} // namespace ndframe
