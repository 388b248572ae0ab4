#include "ndframe/driver/main.hpp"

#include <unistd.h>

#include <iostream>
#include <new>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "error_screen.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/plan.hpp"
#include "ndframe/driver/run.hpp"
#include "outputs.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

struct CommandLine
{
  std::string deck;
  std::vector<std::string> settings;
  std::optional<std::string> help; ///< list to explain; empty text: the command line itself
  bool check = false, plan = false, list = false, dumpDefaults = false, reference = false, version = false;
  bool quiet = false, verbose = false;
};

/// Declares the options; CLI11 fills `options` when it parses.
void declareOptions(CLI::App& app, CommandLine& options)
{
  app.set_help_flag();
  app.add_option("-i,--input,deck", options.deck, "The deck to run.")->type_name("FILE");
  app.add_option(
         "--set", options.settings,
         "Replace or add one entry of the deck, e.g. --set \"Coupling/Stopping/Tolerance=1e-4\"; may be repeated.")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all();
  app.add_flag("--check", options.check, "Check everything, mesh files included, and stop before the solve.");
  app.add_flag("--plan", options.plan, "Show the stages that this deck will run, those it skips, and why.");
  app.add_option_function<std::string>(
         "-h,--help", [&options](const std::string& list) { options.help = list; },
         "This text, or the documentation of a list or component of the deck.")
      ->type_name("LIST")
      ->expected(0, 1)
      ->default_str("");
  app.add_flag("--list", options.list, "All components by list.");
  app.add_flag("--dump-defaults", options.dumpDefaults, "A deck that runs, with every parameter and its default.");
  app.add_flag("--reference", options.reference, "The whole deck reference as Markdown (docs/reference.md).");
  app.add_flag("--version", options.version, "The version.");
  app.add_flag("-q,--quiet", options.quiet, "Nothing on the screen but warnings and errors.");
  app.add_flag("-v,--verbose", options.verbose, "More: ordering, size of the factors.");
}

constexpr const char* exitCodeText = "\nExit codes: 0 right, 1 a bug, 2 the user's input, 3 not converged, or a bound "
                                     "without the guarantee that the deck requires (results are written and marked), "
                                     "4 an expectation missed.\n";

/// The questions that need no deck; true when one was asked.
bool answer(const CommandLine& options, const CLI::App& app, const Components& components, std::ostream& out)
{
  if (options.version)
    out << "ndframe " << versionText() << "\n";
  else if (options.help && options.help->empty())
    out << app.help() << exitCodeText << "\n"
        << "`ndframe --help Coupling` explains a list of the deck, `ndframe --list` shows all components.\n";
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

Params readParams(const CommandLine& options, const Components& components)
{
  if (options.deck.empty())
    throw InputError("no deck was given; run `ndframe -i decks/punch.xml`, or `ndframe --help`.");
  DeckList deck = readDeck(options.deck);
  Diagnostics diagnostics;
  for (const auto& setting : options.settings)
    applySetting(deck, setting, diagnostics);
  Params params = validate(deck, makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  return params;
}

/// Errors and misses go to the standard error stream, also with -q; one rank speaks.
void complain(const Comm& comm, const std::string& text)
{
  if (comm.rank() == 0)
    std::cerr << text << std::endl;
}

/// Says which expectations were missed; true if none was.
bool reportExpectations(const RunSummary& summary, const Comm& comm, const Log& log)
{
  bool allMet = true;
  for (const auto& e : summary.expectations) {
    if (e.met)
      log.line(fmt::format("  expected {}: {:.10g}, right within {:g}", e.name, e.value, e.tolerance));
    else
      complain(comm, fmt::format("  MISSED {}: {:.10g} instead of {:.10g} +- {:g}", e.name, e.value, e.expected,
                                 e.tolerance));
    allMet = allMet && e.met;
  }
  return allMet;
}

ExitCode solveDeck(const Params& deck, const CommandLine& options, const Components& components, const Comm& comm,
                   const Log& log, bool& computed)
{
  Ledger ledger(&log);
  Run run = runDeck(deck, components, comm, ledger, log);
  computed = true;
  const auto written = writeResults(run, deck, options.deck, comm, ledger);
  copyLedger(run.summary, ledger, run.startSeconds);
  if (!run.states.empty())
    log.line("\n" + closingText(run.summary));
  if (run.summary.errors)
    log.line("\n" + errorText(*run.summary.errors));
  log.line("\n" + stageText(run.summary) + "\n");
  const bool allMet = reportExpectations(run.summary, comm, log);
  log.line(fmt::format("  {}   {:.2f} s, {:.0f} MB",
                       written.empty() ? "wrote nothing" : fmt::format("wrote {}", fmt::join(written, ", ")),
                       run.summary.totalSeconds, double(run.summary.peakBytes) / 1e6));
  if (!run.failure.empty()) {
    complain(comm, fmt::format("{}; the results are marked so.", run.failure));
    return ExitCode::NotConverged;
  }
  return allMet ? ExitCode::Right : ExitCode::ExpectationMissed;
}

ExitCode runCommand(const CommandLine& options, const Components& components, const Comm& comm, const Log& log,
                    bool& computed)
{
  const Params deck = readParams(options, components);
  const auto title = deck.get<std::string>("Title");
  log.line(fmt::format("ndframe {}   {}   ({})\n", versionText(), title, options.deck));
  if (options.plan) {
    log.line(Plan(deck, *components.linearSolvers.build(deck.sub("Linear Solver")), comm.size()).text());
    return ExitCode::Right;
  }
  checkOutputFolder(deck.sub("Output"));
  if (options.check) {
    Ledger ledger(&log);
    checkDeck(deck, components, ledger);
    log.line("  the deck is right: meshes, sides, supports and expectations checked; nothing was solved.");
    return ExitCode::Right;
  }
  return solveDeck(deck, options, components, comm, log, computed);
}

ExitCode reportInputError(const InputError& error, bool computed, const Comm& comm)
{
  complain(comm, error.what());
  const auto count = error.list().size();
  complain(comm, fmt::format("{} error{}; {}", count, count == 1 ? "" : "s",
                             computed ? "the results could not be written." : "nothing was computed."));
  return ExitCode::UserInput;
}

/// A failure that the other ranks may know nothing of: whoever has it speaks, and all processes end.
ExitCode failAlone(const Comm& comm, ExitCode code, const std::string& text)
{
  std::cerr << text << std::endl;
  comm.abort(int(code));
  return code;
}

/// Turns everything that can go wrong into a message and an exit code.
ExitCode guarded(const CommandLine& options, const CLI::App& app, const Components& components, const Comm& comm,
                 const Log& log)
{
  bool computed = false;
  try {
    if (comm.rank() != 0 &&
        (options.version || options.help || options.list || options.reference || options.dumpDefaults))
      return ExitCode::Right;
    if (answer(options, app, components, std::cout))
      return ExitCode::Right;
    return runCommand(options, components, comm, log, computed);
  } catch (const InputError& error) {
    return reportInputError(error, computed, comm);
  } catch (const NotConverged& error) {
    complain(comm, fmt::format("not converged: {}", error.what()));
    return ExitCode::NotConverged;
  } catch (const std::bad_alloc&) {
    return failAlone(
        comm, ExitCode::UserInput,
        "this deck needs more memory than the process may take; use a coarser mesh, more ranks or a Krylov "
        "solver.");
  } catch (const std::exception& error) {
    return failAlone(comm, ExitCode::Bug,
                     fmt::format("a bug in ndframe: {}\nPlease report it together with the deck.", error.what()));
  }
}

} // namespace

int runMain(int argc, char** argv, const Extension& extend)
{
  const Comm comm = Comm::world(argc, argv);
  CommandLine options;
  CLI::App app("Certified unilateral contact between elastic bodies by Neumann-Dirichlet domain decomposition.",
               "ndframe");
  declareOptions(app, options);
  ExitCode code = ExitCode::Right;
  try {
    app.parse(argc, argv);
    const Verbosity verbosity =
        options.quiet ? Verbosity::Quiet : (options.verbose ? Verbosity::Verbose : Verbosity::Normal);
    const Log log(std::cout, verbosity, comm.rank() == 0, isatty(STDOUT_FILENO) != 0);
    const auto components = makeComponents(extend);
    code = guarded(options, app, *components, comm, log);
  } catch (const CLI::ParseError& error) {
    if (comm.rank() == 0)
      std::cerr << "ndframe: " << error.what() << "\n`ndframe --help` shows the options.\n";
    code = ExitCode::UserInput;
  }
  finishMpi();
  return int(code);
}

} // namespace ndframe
