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
  ListPlace place;
  std::string directory, name; ///< folder and beginning of the files' names; empty name: the deck's
  bool exodus = true, summary = true, contactTable = true, levelTable = true;
  bool report = false;     ///< NAME.report.html
  bool allLevels = false;  ///< every level of a run with a target
  bool checkpoint = false; ///< NAME.checkpoint
  StepsWritten steps = StepsWritten::Final;
  bool equilibratedStress = false, meanStress = false; ///< in NAME.e
  std::vector<ProbeOptions> probes;                    ///< in the summary
  bool probeTable = false;                             ///< and in NAME.probes.csv
};

} // namespace ndframe
