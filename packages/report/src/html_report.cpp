#include "ndframe/report/html_report.hpp"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/python_script.hpp"

namespace ndframe
{

namespace
{

namespace fs = std::filesystem;

/// Folder of the scripts; throws InputError where they are not installed.
fs::path scriptFolder()
{
  std::error_code failure;
  const char* const given = std::getenv("NDFRAME_SHARE");
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path share = given != nullptr && *given != '\0'
                             ? fs::path(given)
                             : (program.parent_path().parent_path() / NDFRAME_SHARE_DIR).lexically_normal();
  fs::path scripts = share / "ndreport";
  if (!fs::exists(scripts / "__main__.py", failure))
    throw InputError(fmt::format("the report's scripts are not in {}; install all of ndframe, or name the folder "
                                 "share/ndframe of an installation in NDFRAME_SHARE.",
                                 scripts.string()));
  return scripts;
}

} // namespace

int runReport(const std::vector<std::string>& arguments)
{
  std::vector<std::string> words{scriptFolder().string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int code = runPython(words, false);
  if (code == pythonNotStarted)
    throw InputError(fmt::format("reports are made by Python, and {} cannot be started.", pythonProgram));
  return code;
}

void checkReport(const ListPlace& output)
{
  if (runReport({"--check"}) != 0)
    throw InputError(output.mistake("Report", "Python packages are missing, see above."));
}

void checkReport(const OutputOptions& output)
{
  if (!output.report)
    return;
  if (!output.summary)
    throw InputError(output.place.mistake("Report", "a report is made from the summary; Summary must not be false."));
  checkReport(output.place);
}

void writeReport(const std::string& name)
{
  if (runReport({"--quiet", name}) != 0)
    throw InputError(fmt::format("the report of {} was not written; the other files are there.", name));
}

} // namespace ndframe
