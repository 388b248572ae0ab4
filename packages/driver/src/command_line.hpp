#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "new_deck.hpp"

namespace ndframe
{

/// What the user asked for.
struct CommandLine
{
  std::string deck;
  std::vector<std::string> settings;
  std::vector<std::string> axes;   ///< of a study
  std::optional<std::string> help; ///< list to explain; empty text: the command line itself
  std::string logFile;
  std::optional<double> live; ///< seconds
  int decompose = 0;          ///< pieces of each mesh; 0: none
  NewDeck newDeck;            ///< of `ndframe new`
  std::string completion;     ///< shell whose script is wanted
  bool manual = false;
  bool check = false, plan = false, list = false, dumpDefaults = false, reference = false, version = false;
  bool yardstick = false, restart = false;
  bool quiet = false, verbose = false;
};

/// Declares the options; CLI11 fills `options` when it parses.
void declareOptions(CLI::App& app, CommandLine& options);

/// How to go on after a command line that cannot be read: what stands for a word that ndframe does not have, or --help.
std::string wayOut(int argc, const char* const* argv);

/// What the exit codes mean: the end of --help.
const char* exitCodeText();

} // namespace ndframe
