#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

/// Parameters that move together, with their values as written.
struct StudyAxis
{
  std::string name;
  std::vector<Setting> parameters;              ///< path and place; their `value` is not used
  std::vector<std::vector<std::string>> values; ///< per parameter, as many for all

  std::size_t size() const { return values.front().size(); }
};

/// One point of the grid: the values of all parameters that vary, axis by axis, and the deck with them.
struct StudyCase
{
  std::string name; ///< what messages call it: its number from 1, or the name of a load case
  std::vector<std::string> values;
  Params deck;
};

/// What a list Load Cases says besides the cases.
struct LoadCases
{
  bool sharesFiles = true; ///< the cases are the steps of one file; else each has its own, as NAME.CASE.e
  bool writesSummary = true;
  std::string title;
  std::string deckJson; ///< the effective deck with the list
};

/// The list Study of a deck, expanded into a grid; the last axis is the fastest. Or its list Load Cases: one axis,
/// whose parameters are the name of the case and the factors.
struct Study
{
  std::vector<StudyAxis> axes;
  std::vector<StudyCase> cases;
  std::vector<std::string> columns; ///< paths of numbers of the summary
  bool writesFiles = false;         ///< of every case, as FILENAME.1.e, ...
  bool writesReport = false;        ///< of the table
  std::string fileName;             ///< beginning of the names of all files
  std::optional<LoadCases> loads;   ///< absent for a list Study

  const char* list() const { return loads ? "Load Cases" : "Study"; }
  const char* tableEnding() const { return loads ? ".cases" : ".study"; } ///< before .csv
};

/// The list Study.
ListSpec studySpec();

/// Adds "PATH=VALUE; VALUE && PATH=VALUE; VALUE" from the command line: the values replace those of an axis that moves
/// the same parameter; else they are an axis of their own.
void addAxis(DeckList& deck, const std::string& axis, Diagnostics& diagnostics);

/// Expands the deck's list Study. Every case is validated like a deck with these settings; the mistakes of all cases
/// are collected, with the place of the values. `deckName`: the deck's file.
Study expandStudy(const DeckList& deck, const std::string& deckName, const ListSpec& spec, Diagnostics& diagnostics);

} // namespace ndframe
