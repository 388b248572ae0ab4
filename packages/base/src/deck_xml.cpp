#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/help.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

using Names = std::vector<std::string>;

int lineOf(std::string_view text, std::size_t position)
{
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

/// Position of the first "<!" that opens neither a comment nor a CDATA section: a DOCTYPE or an entity declaration.
std::size_t findDeclaration(std::string_view text)
{
  constexpr std::string_view comment = "<!--";
  for (auto at = text.find("<!"); at != std::string_view::npos; at = text.find("<!", at)) {
    const bool isComment = text.substr(at, comment.size()) == comment;
    if (!isComment && text.substr(at, 9) != "<![CDATA[")
      return at;
    const auto end = text.find(isComment ? "-->" : "]]>", at + comment.size());
    if (end == std::string_view::npos)
      return end; // the XML parser says that it does not close
    at = end;
  }
  return std::string_view::npos;
}

void refuseUnsafeText(std::string_view text, const std::string& file)
{
  const auto refuse = [&](std::size_t at, const std::string& message) {
    throw InputError(Diagnostic{file, lineOf(text, at), {}, message});
  };
  if (trimmed(text).empty())
    refuse(0, "is empty; a deck is one <ParameterList> in XML.");
  if (const auto at = findInvalidByte(text))
    refuse(*at, fmt::format("is not UTF-8 text: byte 0x{:02X}; save the deck as UTF-8.",
                            static_cast<unsigned>(static_cast<unsigned char>(text[*at]))));
  const auto at = findDeclaration(text);
  if (at != std::string_view::npos)
    refuse(at, "DOCTYPE and entity declarations (\"<!...\") are not allowed in a deck; remove them.");
}

std::string parserMessage(const tinyxml2::XMLDocument& document)
{
  static const std::map<tinyxml2::XMLError, std::string> reasons{
      {tinyxml2::XML_ERROR_PARSING_ELEMENT, "a tag is malformed or does not end"},
      {tinyxml2::XML_ERROR_PARSING_ATTRIBUTE, "an attribute is malformed or given twice; write name=\"value\" once"},
      {tinyxml2::XML_ERROR_PARSING_TEXT, "there is text outside the tags"},
      {tinyxml2::XML_ERROR_PARSING_CDATA, "a CDATA section does not end"},
      {tinyxml2::XML_ERROR_PARSING_COMMENT, "a comment does not end with \"-->\""},
      {tinyxml2::XML_ERROR_PARSING_DECLARATION, "\"<?...?>\" is malformed or not at the start of the file"},
      {tinyxml2::XML_ERROR_EMPTY_DOCUMENT, "there is no tag in the file"},
      {tinyxml2::XML_ERROR_MISMATCHED_ELEMENT,
       "a tag is closed by another tag's end, or not closed before its list ends"},
      {tinyxml2::XML_ERROR_PARSING, "a tag is not closed before the file ends"},
      {tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED, "the lists are nested too deeply"},
  };
  const auto found = reasons.find(document.ErrorID());
  return fmt::format("is not valid XML: {}.", found == reasons.end() ? document.ErrorName() : found->second);
}

/// Turns the elements of one file into lists and entries, collecting what is wrong with them.
class DeckReader
{
public:
  DeckReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  DeckList readRoot(const tinyxml2::XMLDocument& document)
  {
    const tinyxml2::XMLElement* root = document.RootElement();
    if (root == nullptr)
      throw InputError(Diagnostic{file_, 1, {}, "holds no <ParameterList>."});
    if (root->Name() != std::string("ParameterList"))
      throw InputError(Diagnostic{
          file_, root->GetLineNum(), {}, fmt::format("a deck is one <ParameterList>, not <{}>.", root->Name())});
    for (const auto* node = root->NextSibling(); node != nullptr; node = node->NextSibling())
      if (node->ToComment() == nullptr)
        mistake(*node, {}, "the deck continues after its outer </ParameterList>; only comments may follow it.");
    checkAttributes(*root, {}, {}, {"name"});
    DeckList deck{attribute(*root, "name").value_or(""), file_, root->GetLineNum(), {}, {}};
    readChildren(*root, {}, deck);
    return deck;
  }

private:
  void mistake(const tinyxml2::XMLNode& node, const std::string& path, std::string message)
  {
    diagnostics_.add({file_, node.GetLineNum(), path, std::move(message)});
  }

  static std::optional<std::string> attribute(const tinyxml2::XMLElement& element, const char* name)
  {
    const char* value = element.Attribute(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  }

  /// Reports attributes that are missing, unknown or not plain text. False when one of `required` is missing.
  bool checkAttributes(const tinyxml2::XMLElement& element, const std::string& path, const Names& required,
                       const Names& optional)
  {
    Names known = required;
    known.insert(known.end(), optional.begin(), optional.end());
    for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next())
      checkAttribute(element, path, *a, known);
    bool complete = true;
    for (const auto& name : required)
      if (!attribute(element, name.c_str())) {
        mistake(element, path, missingAttribute(element, name));
        complete = false;
      }
    return complete;
  }

  static std::string missingAttribute(const tinyxml2::XMLElement& element, const std::string& missing)
  {
    const auto name = attribute(element, "name");
    const std::string types =
        missing == "type" ? " (bool, int, double, string, Array(int), Array(double) or Array(string))" : "";
    return fmt::format("<{}{}> has no attribute \"{}\"{}.", element.Name(), name ? " name=" + inQuotes(*name) : "",
                       missing, types);
  }

  void checkAttribute(const tinyxml2::XMLElement& element, const std::string& path, const tinyxml2::XMLAttribute& a,
                      const Names& known)
  {
    static const Names writtenByTeuchos{"id", "docString", "isDefault", "isUsed"};
    const std::string name = a.Name();
    const auto isIn = [&](const Names& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
    if (!isIn(known) && !isIn(writtenByTeuchos))
      mistake(
          element, path,
          fmt::format("<{}> takes no attribute \"{}\"; it takes {}.", element.Name(), name, fmt::join(known, ", ")));
    if (findInvalidByte(a.Value()))
      mistake(element, path, fmt::format("the attribute \"{}\" holds a control character or is not UTF-8.", name));
  }

  void readChildren(const tinyxml2::XMLElement& element, const std::string& path, DeckList& list)
  {
    for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
      const auto* child = node->ToElement();
      if (child == nullptr && node->ToComment() == nullptr)
        mistake(*node, path,
                fmt::format("{} is between the tags; a deck has its values in attributes.",
                            inQuotes(trimmed(node->Value()))));
      else if (child != nullptr)
        readElement(*child, path, list);
    }
  }

  void readElement(const tinyxml2::XMLElement& element, const std::string& path, DeckList& list)
  {
    const std::string tag = element.Name();
    if (tag == "ParameterList")
      return readList(element, path, list);
    if (tag == "Parameter")
      return readEntry(element, path, list);
    const std::string near = nearestName(tag, {"ParameterList", "Parameter"});
    mistake(
        element, path,
        fmt::format("<{}> is unknown; {}", tag,
                    near.empty() ? "a list holds <ParameterList> and <Parameter>." : "did you mean <" + near + ">?"));
  }

  void readList(const tinyxml2::XMLElement& element, const std::string& path, DeckList& parent)
  {
    if (!checkAttributes(element, path, {"name"}, {}))
      return;
    DeckList list{*attribute(element, "name"), file_, element.GetLineNum(), {}, {}};
    if (!checkName(element, path, list.name, parent, false))
      return;
    readChildren(element, path.empty() ? list.name : path + "/" + list.name, list);
    parent.lists.push_back(std::move(list));
  }

  void readEntry(const tinyxml2::XMLElement& element, const std::string& path, DeckList& parent)
  {
    for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling())
      if (node->ToComment() == nullptr)
        mistake(*node, path, "a <Parameter> has no content; its value is in the attribute \"value\".");
    if (!checkAttributes(element, path, {"name", "type", "value"}, {}))
      return;
    DeckEntry entry{*attribute(element, "name"), *attribute(element, "type"), *attribute(element, "value"), file_,
                    element.GetLineNum()};
    if (checkName(element, path, entry.name, parent, true)) // may be a path: of what a study varies
      parent.entries.push_back(std::move(entry));
  }

  /// A name stands once in its list, whether for a parameter or a sublist; a list's can be written in a path.
  bool checkName(const tinyxml2::XMLElement& element, const std::string& path, const std::string& name,
                 const DeckList& parent, bool slashesAreRight)
  {
    const auto* entry = parent.findEntry(name);
    const auto* list = parent.findList(name);
    if (trimmed(name) != name || name.empty() || (!slashesAreRight && name.find('/') != std::string::npos))
      mistake(element, path,
              fmt::format("the name {} is not valid: a name is not empty, {}neither begins nor ends with a space.",
                          inQuotes(name), slashesAreRight ? "" : "holds no \"/\", "));
    else if (entry != nullptr || list != nullptr)
      mistake(element, path,
              fmt::format("{} is given twice, first in line {}; remove one.", inQuotes(name),
                          entry != nullptr ? entry->line : list->line));
    else
      return true;
    return false;
  }

  std::string file_;
  Diagnostics& diagnostics_;
};

} // namespace

DeckList parseDeck(const std::string& xml, const std::string& name)
{
  refuseUnsafeText(xml, name);
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS)
    throw InputError(Diagnostic{name, document.ErrorLineNum(), {}, parserMessage(document)});
  Diagnostics diagnostics;
  DeckList deck = DeckReader(name, diagnostics).readRoot(document);
  diagnostics.throwIfAny();
  return deck;
}

} // namespace ndframe
