#include "answers.hpp"

#include <ostream>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/run/summarize.hpp"

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

} // namespace

bool answer(const CommandLine& options, const CLI::App& app, const Components& components, std::ostream& out)
{
  if (options.version)
    out << "ndframe " << versionText() << "\n";
  else if (options.help && options.help->empty())
    out << app.help() << exitCodeText() << "\n"
        << "`ndframe --help Coupling` explains a list of the deck, `ndframe --list` shows all components.\n";
  else if (options.help && *options.help == "report")
    out << reportHelp;
  else if (options.help)
    out << helpText(makeDeckSpec(components), *options.help);
  else if (options.list)
    out << componentList(makeDeckSpec(components));
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
