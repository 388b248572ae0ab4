#include "ndframe/drawing/deck_writer.hpp"

#include <fmt/format.h>

namespace ndframe
{

namespace
{

std::string quoted(const std::string& text)
{
  std::string out;
  for (const char c : text)
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  return out;
}

/// Two hyphens may not stand in a comment.
std::string harmless(std::string text)
{
  for (auto at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.replace(at, 2, "- ");
  return text;
}

} // namespace

void DeckWriter::open(const std::string& list)
{
  text_ += fmt::format("{}<ParameterList name=\"{}\">\n", margin(), quoted(list));
  ++depth_;
}

void DeckWriter::close()
{
  --depth_;
  text_ += margin() + "</ParameterList>\n";
}

void DeckWriter::comment(const std::string& text)
{
  text_ += fmt::format("{}<!-- {} -->\n", margin(), harmless(text));
}

void DeckWriter::entry(const std::string& name, const std::string& type, const std::string& value)
{
  text_ +=
      fmt::format("{}<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>\n", margin(), quoted(name), type, quoted(value));
}

void DeckWriter::number(const std::string& name, double value)
{
  entry(name, "double", fmt::format("{:.6g}", value));
}

} // namespace ndframe
