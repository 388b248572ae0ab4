#pragma once

#include <string>
#include <vector>

#include "ndframe/run/output_options.hpp"

namespace ndframe
{

/// `ndframe report ARGUMENTS...`: starts the scripts in share/ndframe/ndreport, beside the program or in the folder
/// that the environment variable NDFRAME_SHARE names. Returns their exit code: 0, or 2 when something is missing, which
/// they say. Throws InputError when there are no scripts or no Python.
int runReport(const std::vector<std::string>& arguments);

/// Refuses Output/Report before anything is computed where a package of Python is missing. `output`: the list. One
/// rank.
void checkReport(const ListPlace& output);

/// The same for one run, which also has to write its summary.
void checkReport(const OutputOptions& output);

/// Writes NAME.report.html of the files of NAME, as the command does. Throws InputError when that fails.
void writeReport(const std::string& name);

} // namespace ndframe
