#pragma once

#include <string>

namespace ndframe
{

/// Writes a commented deck, list by list, indented.
class DeckWriter
{
public:
  void open(const std::string& list);    ///< begins a list in the innermost one
  void close();                          ///< ends the innermost list
  void comment(const std::string& text); ///< in lines of its own; "--" is taken apart
  /// An entry of the innermost list. type as in a deck, e.g. "Array(string)".
  void entry(const std::string& name, const std::string& type, const std::string& value);
  void text(const std::string& name, const std::string& value) { entry(name, "string", value); } ///< a string
  void number(const std::string& name, double value); ///< a double, with six digits
  void emptyLine() { text_ += "\n"; }                 ///< between lists

  const std::string& written() const { return text_; } ///< everything so far

private:
  std::string margin() const { return std::string(2 * depth_, ' '); }

  std::string text_;
  std::size_t depth_ = 0;
};

} // namespace ndframe
