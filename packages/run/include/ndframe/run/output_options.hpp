#pragma once

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

/// The list Output, read.
struct OutputOptions
{
  ListPlace place; ///< for mistakes that show later
  /// Relative to the working directory; made if missing.
  std::string directory, name; ///< folder and beginning of the files' names; empty name: the deck's
  /// NAME.e, NAME.summary.json, NAME.contact.csv (with interfaces) and NAME.levels.csv (with a target) are written.
  bool exodus = true, summary = true, /**< JSON */ contactTable = true, /**< CSV */ levelTable = true; ///< CSV
  bool report = false;                      ///< NAME.report.html
  bool allLevels = false;                   ///< every level of a run with a target
  bool checkpoint = false;                  ///< NAME.checkpoint
  StepsWritten steps = StepsWritten::Final; ///< of NAME.e
  /// Element means of sigma^ and of the mean stress (sigma^ + K eps(u^)) / 2 are written.
  bool equilibratedStress = false, meanStress = false; ///< in NAME.e
  std::vector<ProbeOptions> probes;                    ///< in the summary
  bool probeTable = false;                             ///< and in NAME.probes.csv
};

} // namespace ndframe
