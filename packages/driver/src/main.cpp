#include "ndframe/driver/main.hpp"

#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <limits>
#include <new>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line.hpp"
#include "error_screen.hpp"
#include "ndframe/algebra/library_memory.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/plan.hpp"
#include "ndframe/driver/run.hpp"
#include "outputs.hpp"
#include "screen.hpp"
#include "signals.hpp"
#include "study.hpp"
#include "summarize.hpp"
#include "yardstick.hpp"

namespace ndframe
{
namespace
{

/// The questions that need no deck; true when one was asked.
bool answer(const CommandLine& options, const CLI::App& app, const Components& components, std::ostream& out)
{
  if (options.version)
    out << "ndframe " << versionText() << "\n";
  else if (options.help && options.help->empty())
    out << app.help() << exitCodeText() << "\n"
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

/// The deck with the settings and axes of the command line, not validated.
DeckList readInput(const CommandLine& options, Diagnostics& diagnostics)
{
  if (options.deck.empty())
    throw InputError("no deck was given; run `ndframe -i decks/punch.xml`, or `ndframe --help`.");
  DeckList deck = readDeck(options.deck);
  for (const auto& setting : options.settings)
    applySetting(deck, setting, diagnostics);
  for (const auto& axis : options.axes)
    addAxis(deck, axis, diagnostics);
  return deck;
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

void greet(const Params& deck, const CommandLine& options, const Log& log)
{
  log.line(fmt::format("ndframe {}   {}   ({})\n", versionText(), deck.get<std::string>("Title"), options.deck));
}

ExitCode runStudy(const DeckList& deck, const CommandLine& options, const Components& components, const Comm& comm,
                  const Log& log, Diagnostics& diagnostics, bool& computed)
{
  const Study study = expandStudy(deck, options.deck, makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  const Params& first = study.cases.front().deck;
  greet(first, options, log);
  if (options.yardstick)
    throw InputError("--yardstick measures one scene; run it without a study.");
  if (options.plan) {
    log.line(Plan(first, *components.linearSolvers.build(first.sub("Linear Solver")), comm.size()).text());
    log.line("\n" + studyPlan(study));
    return ExitCode::Right;
  }
  claimLibraryMemory();
  StudyRunner runner(study, options.deck, components, comm);
  return options.check ? runner.check(log) : runner.run(log, computed);
}

ExitCode runCommand(const CommandLine& options, const Components& components, const Comm& comm, const Log& log,
                    bool& computed)
{
  Diagnostics diagnostics;
  const DeckList input = readInput(options, diagnostics);
  if (input.findList("Study") != nullptr)
    return runStudy(input, options, components, comm, log, diagnostics, computed);
  const Params deck = validate(input, makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  greet(deck, options, log);
  if (options.plan) {
    log.line(Plan(deck, *components.linearSolvers.build(deck.sub("Linear Solver")), comm.size()).text());
    return ExitCode::Right;
  }
  checkOutputFolder(deck.sub("Output"));
  claimLibraryMemory();
  if (options.check) {
    Ledger ledger(&log);
    checkDeck(deck, components, comm, ledger);
    log.line("  the deck is right: meshes, sides, supports and expectations checked; nothing was solved.");
    return ExitCode::Right;
  }
  if (options.yardstick) {
    log.line(yardstickText(deck, components, options.deck, comm));
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
ExitCode failAlone(const Comm& comm, ExitCode code, std::string_view text)
{
  std::cerr << text << std::endl;
  comm.abort(int(code));
  return code;
}

/// Ends the process at once: at a normal exit OpenBLAS waits for its threads, which may ask for memory for ever.
[[noreturn]] void failForMemory(const Comm& comm)
{
  const auto code = failAlone(comm, ExitCode::UserInput, needsMoreMemory);
  std::cout.flush();
  std::_Exit(int(code));
}

ExitCode failAsBug(const Comm& comm, const std::exception& error)
{
  return failAlone(comm, ExitCode::Bug,
                   fmt::format("a bug in ndframe: {}\nPlease report it together with the deck.", error.what()));
}

/// Large arrays come and go in every stage. Handing their pages back to the kernel and taking them again, zeroed, costs
/// a twentieth of a run.
void keepFreedMemory()
{
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
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
  } catch (const SingularBody& error) { // met by an iterative solver on its way
    complain(comm, fmt::format("not converged: {}", error.what()));
    return ExitCode::NotConverged;
  } catch (const std::bad_alloc&) {
    failForMemory(comm);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) // a thread's stack
      failForMemory(comm);
    return failAsBug(comm, error);
  } catch (const std::exception& error) {
    return failAsBug(comm, error);
  }
}

/// The code of a run whose screen could not be written.
ExitCode checkScreen(ExitCode code, const Comm& comm)
{
  const char* const reason = lostOutput();
  if (reason == nullptr || comm.rank() != 0)
    return code;
  std::cerr << "cannot write to the standard output: " << reason << std::endl;
  return code == ExitCode::Right ? ExitCode::UserInput : code;
}

} // namespace

int runMain(int argc, char** argv, const Extension& extend)
{
  keepFreedMemory();
  prepareProcess();
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
  } catch (const std::bad_alloc&) {
    failForMemory(comm);
  }
  code = checkScreen(code, comm);
  finishMpi();
  return int(code);
}

} // namespace ndframe
