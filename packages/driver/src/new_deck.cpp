#include "new_deck.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "deck_templates.hpp"
#include "drawn_deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "shell_files.hpp"

namespace ndframe
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* fromDrawing = "from-geo";
constexpr const char* drawnText = "the bodies of a gmsh file (.geo or .msh), with sides, contacts, supports and loads "
                                  "as far as the drawing tells";

bool isDrawing(const std::string& file)
{
  const std::string ending = fs::path(file).extension().string();
  return ending == ".geo" || ending == ".msh";
}

/// The text of a template that needs no drawing.
std::string plainText(const NewDeck& wanted)
{
  for (const DeckTemplate& one : deckTemplates())
    if (one.name == wanted.name)
      return one.text;
  const auto known = templateNames();
  const std::string near = nearestName(wanted.name, known);
  if (wanted.name.empty())
    throw InputError(fmt::format("say which deck: ndframe new {}.", fmt::join(known, "|")));
  if (isDrawing(wanted.name))
    throw InputError(fmt::format("a deck for a drawing is made by ndframe new from-geo {}.", forShell(wanted.name)));
  throw InputError(fmt::format("there is no template \"{}\"{}; there are {}.", wanted.name,
                               near.empty() ? "" : fmt::format("; did you mean \"{}\"", near), fmt::join(known, ", ")));
}

void checkDrawing(const NewDeck& wanted)
{
  if (wanted.drawing.empty())
    throw InputError("from-geo needs a file: ndframe new from-geo FILE.geo (or FILE.msh).");
  if (!isDrawing(wanted.drawing))
    throw InputError(fmt::format("{}: from-geo reads .geo and .msh files of gmsh.", wanted.drawing));
  if (!fs::exists(wanted.drawing))
    throw InputError(fmt::format("{}: there is no such file.", wanted.drawing));
}

fs::path outputOf(const NewDeck& wanted)
{
  if (!wanted.output.empty())
    return wanted.output;
  return wanted.drawing.empty() ? wanted.name + ".xml" : fs::path(wanted.drawing).stem().string() + ".xml";
}

} // namespace

void refuseDrawing(const std::string& deck)
{
  if (isDrawing(deck))
    throw InputError(
        fmt::format("{}: is a drawing, not a deck; ndframe new from-geo {} makes a deck of it.", deck, forShell(deck)));
}

std::vector<std::string> templateNames()
{
  std::vector<std::string> names;
  for (const DeckTemplate& one : deckTemplates())
    names.emplace_back(one.name);
  names.emplace_back(fromDrawing);
  return names;
}

std::string templateHelp()
{
  std::string text = "\nTemplates:\n";
  for (const DeckTemplate& one : deckTemplates())
    text += fmt::format("  {:<12} {}\n", one.name, one.what);
  return text + fmt::format("  {:<12} {}\n", fromDrawing, drawnText);
}

WrittenDeck writeNewDeck(const NewDeck& wanted, const Components& components)
{
  const bool isDrawn = wanted.name == fromDrawing;
  const std::string plain = isDrawn ? "" : plainText(wanted);
  if (isDrawn)
    checkDrawing(wanted);
  else if (!wanted.drawing.empty())
    throw InputError(fmt::format("{} takes no file; from-geo does.", wanted.name));
  const fs::path output = outputOf(wanted);
  if (!wanted.replace && fs::exists(output))
    throw InputError(fmt::format("{} exists already; name another file with --output, or use --force to replace it.",
                                 output.string()));
  const DrawnDeck deck = isDrawn ? drawnDeck(wanted.drawing, output.string(), components) : DrawnDeck{plain, {}};
  writeTextAtomically(output.string(), deck.text);
  return {output.string(), deck.mistakes};
}

std::string writtenText(const WrittenDeck& deck)
{
  return deck.mistakes.empty() ? fmt::format("  wrote {}; run it: ndframe {}", deck.file, forShell(deck.file))
                               : fmt::format("  wrote {}, which does not run yet:", deck.file);
}

} // namespace ndframe
