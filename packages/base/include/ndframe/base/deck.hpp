#pragma once

#include <string>
#include <vector>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

/// A deck as written: a tree of lists and untyped entries that remember their lines.
struct DeckEntry
{
  std::string name;  ///< unique in its list; may be a path, of what a study varies
  std::string type;  ///< "bool", "int", "double", "string", "Array(int)", ...; empty when it came from a setting
  std::string value; ///< as written
  std::string file;  ///< empty when it came from `--set`
  int line = 0;      ///< 1-based; 0 when it came from `--set`
};

/// A list with its entries and the lists in it, in the order in which they are written.
struct DeckList
{
  std::string name;               ///< of the deck itself: may be empty
  std::string file;               ///< empty when `--set` made it
  int line = 0;                   ///< 1-based; 0 when `--set` made it
  std::vector<DeckEntry> entries; ///< its parameters
  std::vector<DeckList> lists;    ///< its sublists; no name stands twice, of entries and lists

  const DeckEntry* findEntry(const std::string& entryName) const; ///< null if there is none
  const DeckList* findList(const std::string& listName) const;    ///< null if there is none
};

/// Reads a Teuchos XML deck. Unreadable files, XML that does not parse, DOCTYPE and entity declarations (never
/// expanded), unknown elements, missing attributes, duplicated keys and duplicated sublists (Teuchos would merge them)
/// are InputErrors, reported together where the parser can go on. Limits: UTF-8, 4 MB, a hundred levels of lists.
DeckList readDeck(const std::string& path);

/// The same from a text; `name` stands for the file in messages.
DeckList parseDeck(const std::string& xml, const std::string& name);

/// A value for the entry at a path such as "Coupling/Stopping/Tolerance", and where that was written.
struct Setting
{
  /// Names of lists and key, with "/" between.
  std::string path, value; ///< of the key, as a deck would have it
  std::string file;        ///< empty: `--set`
  int line = 0;            ///< 1-based; 0 for `--set`
};

/// Replaces the entry or adds it, creating lists on the way. It is validated later like the rest of the deck.
void applySetting(DeckList& deck, const Setting& setting, Diagnostics& diagnostics);

/// The same for "Coupling/Stopping/Tolerance=1e-4" from the command line.
void applySetting(DeckList& deck, const std::string& setting, Diagnostics& diagnostics);

} // namespace ndframe
