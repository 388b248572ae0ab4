#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/base/list_place.hpp"
#include "ndframe/run/probe_options.hpp"

namespace ndframe
{

/// Which states NAME.e holds.
enum class StepsWritten
{
  Final,
  AllSweeps
};

/// How a deck calls them.
const Names<StepsWritten>& stepsNames();

/// Of how many files NAME.e consists.
enum class ExodusFiles
{
  Automatic, ///< pieces for large scenes on several processes
  Single,    ///< written by one process
  Pieces     ///< NAME.e.N.r, each by its process; one process writes NAME.e
};

/// How a deck calls them.
const Names<ExodusFiles>& exodusFilesNames();

/// Scenes with fewer nodes are written as one file by ExodusFiles::Automatic.
constexpr std::int64_t leastNodesInPieces = 1'000'000;

/// Whether NAME.e of a scene with so many nodes is written in pieces by so many processes; one writes the whole.
bool writesPieces(ExodusFiles files, std::int64_t nodes, int processes);

/// The list Output, read.
struct OutputOptions
{
  ListPlace place; ///< for mistakes that show later
  /// Relative to the working directory; made if missing.
  std::string directory, name; ///< folder and beginning of the files' names; empty name: the deck's
  /// NAME.e, NAME.summary.json, NAME.contact.csv (with interfaces) and NAME.levels.csv (with a target) are written.
  bool exodus = true, summary = true, /**< JSON */ contactTable = true, /**< CSV */ levelTable = true; ///< CSV
  ExodusFiles exodusFiles = ExodusFiles::Automatic; ///< of NAME.e and of the levels' files
  bool report = false;                              ///< NAME.report.html
  bool allLevels = false;                           ///< every level of a run with a target
  bool checkpoint = false;                          ///< NAME.checkpoint
  int checkpointSweeps = 0;                         ///< also after so many sweeps each; 0: only after levels
  StepsWritten steps = StepsWritten::Final;         ///< of NAME.e
  /// Element means of sigma^ and of the mean stress (sigma^ + K eps(u^)) / 2 are written.
  bool equilibratedStress = false, meanStress = false; ///< in NAME.e
  std::vector<ProbeOptions> probes;                    ///< in the summary
  bool probeTable = false;                             ///< and in NAME.probes.csv
};

} // namespace ndframe
