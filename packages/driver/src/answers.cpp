#include "answers.hpp"

#include <ostream>

#include <fmt/format.h>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/build_info.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/run/summarize.hpp"
#include "shell_files.hpp"

namespace ndframe
{

namespace
{

constexpr const char* reportHelp =
    "ndframe report NAME [--output FILE]\n\n"
    "  Writes NAME.report.html, one page that needs no other file: the scene in words and as a drawing, a verdict in "
    "one\n"
    "  sentence, pictures of the bodies, of the contact and of the error, tables, and the deck with all defaults.\n\n"
    "  NAME is the beginning of the file names of a run or a study, or one of the files: punch, results/punch,\n"
    "  punch.summary.json, certificate.study.csv. Output/Report = true in the deck does it at the end of a run.\n\n"
    "  Needs the Debian packages python3-netcdf4, python3-matplotlib and python3-jinja2. Exit codes: 0 written, 2 a "
    "file\n"
    "  or a package is missing. docs/results.md, Report, describes the page.\n";

/// What --version says.
std::string versionLines(const Comm& comm)
{
  const BuildInfo& build = buildInfo();
  std::string text =
      fmt::format("ndframe {}\ncommit {}, {} build, {}\n", versionText(), build.commit, build.type, build.compiler);
  for (const auto& [name, version] : build.libraries)
    text += fmt::format("{} {}\n", name, version);
  const int threads = numThreads(comm), processes = comm.size();
  text += fmt::format("here: {} {} per process (OMP_NUM_THREADS), {} {} (mpirun)\n", threads,
                      threads == 1 ? "thread" : "threads", processes, processes == 1 ? "process" : "processes");
  return text;
}

/// What --help says of a word.
std::string topicText(const std::string& word, const Components& components)
{
  const std::string limit = limitOf(word);
  return limit.empty() ? helpText(makeDeckSpec(components), word)
                       : fmt::format("{}: {}\ndocs/limits.md lists what else is not.\n", word, limit);
}

} // namespace

bool answer(const CommandLine& options, const CLI::App& app, const Components& components, const Comm& comm,
            std::ostream& out)
{
  if (options.version)
    out << versionLines(comm);
  else if (options.help && app.get_subcommand("report")->parsed()) // --help report
    out << reportHelp;
  else if (options.help && app.get_subcommand("new")->parsed())
    out << app.get_subcommand("new")->help("ndframe") << templateHelp()
        << "\nExit codes: 0 written, 2 the file exists already, the drawing cannot be used, or the deck was written "
           "and does not run yet.\n";
  else if (options.help && options.help->empty())
    out << app.help() << exitCodeText() << "\n"
        << "To begin: `ndframe new two-bodies`, or `ndframe new from-geo FILE.geo` for a drawing of your own; then "
           "`ndframe DECK`, and `ndframe report NAME` for a page of its results.\n"
        << "`ndframe --help Coupling` explains a list of the deck, `ndframe --help \"maximum sweeps\"` finds a "
           "parameter, "
           "`ndframe --list` shows all components.\n";
  else if (options.help)
    out << topicText(*options.help, components);
  else if (options.list)
    out << componentList(makeDeckSpec(components));
  else if (!options.completion.empty())
    out << completionScript(options.completion, app, makeDeckSpec(components));
  else if (options.manual)
    out << manualPage(app);
  else if (options.reference)
    out << referenceMarkdown(makeDeckSpec(components));
  else if (options.dumpDefaults) {
    Diagnostics diagnostics;
    out << toXml(validate(parseDeck(defaultDeck(), "default"), makeDeckSpec(components), diagnostics));
    diagnostics.throwIfAny();
  } else
    return false;
  return true;
}

} // namespace ndframe
