#pragma once

#include <string>

namespace ndframe
{

/// Writes a commented deck, list by list, indented.
class DeckWriter
{
public:
  void open(const std::string& list);
  void close();
  void comment(const std::string& text);
  /// An entry of the innermost list. type as in a deck, e.g. "Array(string)".
  void entry(const std::string& name, const std::string& type, const std::string& value);
  void text(const std::string& name, const std::string& value) { entry(name, "string", value); }
  void number(const std::string& name, double value);
  void emptyLine() { text_ += "\n"; }

  const std::string& written() const { return text_; }

private:
  std::string margin() const { return std::string(2 * depth_, ' '); }

  std::string text_;
  std::size_t depth_ = 0;
};

} // namespace ndframe
