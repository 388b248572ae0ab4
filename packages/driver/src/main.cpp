#include "ndframe/driver/main.hpp"

#include <malloc.h>
#include <unistd.h>

#include <iostream>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "accuracy_list.hpp"
#include "answers.hpp"
#include "command_line.hpp"
#include "decompose.hpp"
#include "failures.hpp"
#include "load_cases.hpp"
#include "ndframe/algebra/launcher.hpp"
#include "ndframe/algebra/library_memory.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/run_deck.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "ndframe/report/accuracy_screen.hpp"
#include "ndframe/report/checkpoint_file.hpp"
#include "ndframe/report/error_screen.hpp"
#include "ndframe/report/html_report.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/screen.hpp"
#include "ndframe/run/energy_comparison.hpp"
#include "ndframe/run/memory_plan.hpp"
#include "ndframe/run/plan.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/run/warnings.hpp"
#include "screen_files.hpp"
#include "signals.hpp"
#include "study.hpp"
#include "yardstick.hpp"

namespace ndframe
{
namespace
{

/// What becomes of the files of a run that ends without a solution.
constexpr const char* noSolution = "there is no solution: none is written, and files of an earlier one are removed";

/// The deck with the settings and axes of the command line, not validated.
DeckList readInput(const CommandLine& options, Diagnostics& diagnostics)
{
  if (options.deck.empty())
    throw InputError(
        "no deck was given; `ndframe new two-bodies` writes one to begin with, `ndframe --help` says more.");
  refuseDrawing(options.deck);
  DeckList deck = readDeck(options.deck);
  for (const auto& setting : options.settings)
    applySetting(deck, setting, diagnostics);
  for (const auto& axis : options.axes)
    addAxis(deck, axis, diagnostics);
  return deck;
}

/// Says which expectations were missed.
void reportExpectations(const RunSummary& summary, const Comm& comm, const Log& log)
{
  for (const auto& e : summary.expectations) {
    if (e.met)
      log.line(fmt::format("  expected {}: {:.10g}, right within {:g}", e.name, e.value, e.tolerance));
    else
      complain(comm, fmt::format("  MISSED {}: {:.10g} instead of {:.10g} +- {:g}", e.name, e.value, e.expected,
                                 e.tolerance));
  }
}

void reportWarnings(const std::vector<WarningSummary>& warnings, const Comm& comm)
{
  for (const auto& warning : warnings)
    complain(comm, warningText(warning));
}

/// Says why the answer is not what the deck asks for, if it is not.
void reportShortcomings(const Run& run, const Comm& comm)
{
  if (!run.bug.empty())
    complain(comm, run.bug);
  if (!run.failure.empty())
    complain(comm, fmt::format("{}; {}.", run.failure, run.summary.solved ? "the results are marked so" : noSolution));
  else if (const std::string missed = missedTarget(run.summary); !missed.empty())
    complain(comm, missed + ".");
  else if (codeOf(run) == ExitCode::Warned)
    complain(comm, "Strict Input allows no warnings; the results are written.");
}

ExitCode solveDeck(const RunSettings& settings, const CommandLine& options, const Components& components,
                   const Comm& comm, const Log& log, bool& computed)
{
  Ledger ledger(&log);
  const LevelObserver writer = levelWriter(settings.output, options.deck, comm, ledger);
  const LevelObserver onLevel = [&](const Run& level, int number) {
    computed = true;
    if (writer)
      writer(level, number);
  };
  CheckpointFile checkpoint;
  openCheckpoint(checkpoint, settings, options.deck, options.restart, comm, log);
  Run run = runDeck(settings, components, comm, ledger, log, {}, onLevel, checkpoint.restart);
  computed = true;
  const auto written = writeResults(run, settings.output, options.deck, comm, ledger);
  endCheckpoint(checkpoint, run, written, comm);
  copyLedger(run.summary, ledger, run.startSeconds);
  if (run.summary.solved)
    log.line("\n" + closingText(run.summary));
  if (run.summary.errors)
    log.line("\n" + errorText(*run.summary.errors));
  if (run.summary.errors && run.summary.errors->energyBracket)
    log.line(energyText(*run.summary.errors->energyBracket));
  if (run.summary.accuracy && run.summary.errors)
    log.line("\n  " + accuracyText(*run.summary.accuracy, run.summary.errors->guaranteed));
  log.line("\n" + stageText(run.summary) + "\n");
  reportExpectations(run.summary, comm, log);
  reportWarnings(run.summary.warnings, comm);
  log.line(fmt::format("  {}   {:.2f} s, {:.0f} MB", written.empty() ? "wrote nothing" : "wrote " + namesText(written),
                       run.summary.totalSeconds, double(run.summary.peakBytes) / 1e6));
  reportShortcomings(run, comm);
  return codeOf(run);
}

std::string planText(const RunSettings& settings, const Components& components, const Comm& comm)
{
  const auto solver = components.linearSolvers.build(settings.scene.linearSolver);
  const bool solvesWhole =
      settings.outline.interfaces > 0 && components.couplings.build(settings.couplingList)->solvesWhole(3);
  return fmt::format("{}\n\n  memory: {}", Plan(settings, *solver, comm.size()).text(),
                     memoryPlan(settings, *solver, solvesWhole, comm.size()));
}

void greet(const RunSettings& settings, const CommandLine& options, const Log& log)
{
  log.line(fmt::format("ndframe {}   {}   ({})", versionText(), settings.title, options.deck));
  if (const Launcher launcher = launcherOfThisProcess(); launcher.sharesProcessors())
    log.line(fmt::format("  note: {} processes wait for each other here, for there are fewer processors; one on each "
                         "processor takes less time.",
                         launcher.sizeHere));
  log.line("");
}

/// Runs the cases of a list Study or Load Cases.
ExitCode runStudy(const DeckList& deck, const CommandLine& options, const Components& components, const Comm& comm,
                  const Log& log, Diagnostics& diagnostics, bool& computed)
{
  const auto expand = deck.findList("Load Cases") != nullptr ? expandLoadCases : expandStudy;
  const Study study = expand(deck, options.deck, makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  const RunSettings first = readSettings(study.cases.front().deck);
  greet(first, options, log);
  if (options.yardstick)
    throw InputError("--yardstick measures one scene; run it without a study or load cases.");
  if (options.decompose > 0)
    throw InputError("--decompose reads one scene; run it without a study or load cases.");
  if (options.restart || first.output.checkpoint)
    throw InputError("--restart and Output/Checkpoint are for one run; remove them, or run the cases one by one.");
  if (options.plan) {
    log.line(planText(first, components, comm) + "\n\n" + studyPlan(study));
    return ExitCode::Right;
  }
  claimLibraryMemory();
  StudyRunner runner(study, options.deck, components, comm, log);
  return options.check ? runner.check() : runner.run(computed);
}

ExitCode runInput(const CommandLine& options, const Components& components, const Comm& comm, const Log& log,
                  bool& computed)
{
  Diagnostics diagnostics;
  DeckList input = readInput(options, diagnostics);
  if (input.findList("Study") != nullptr || input.findList("Load Cases") != nullptr)
    return runStudy(input, options, components, comm, log, diagnostics, computed);
  completeAccuracyDeck(input, diagnostics);
  const Params deck = validateScene(input, makeDeckSpec(components), diagnostics);
  diagnostics.throwIfAny();
  const RunSettings settings = readSettings(deck);
  greet(settings, options, log);
  if (options.plan) {
    log.line(planText(settings, components, comm));
    return ExitCode::Right;
  }
  checkOutput(settings, options.deck);
  writeOnFirstRank(comm, [&] { checkReport(settings.output); });
  claimLibraryMemory();
  if (options.check) {
    Ledger ledger(&log);
    Model model;
    const RunSettings checked = checkDeck(model, settings, components, comm, ledger, log);
    for (const auto& warning : sceneWarnings(model, checked))
      complain(comm, warningText(warningSummary(warning)));
    log.line("  the deck is valid: meshes, sides, supports and expectations checked; nothing was solved.");
    return ExitCode::Right;
  }
  if (options.decompose > 0) {
    log.line(decompose(settings, options.decompose, components, options.deck, comm));
    return ExitCode::Right;
  }
  if (options.yardstick) {
    log.line(yardstickText(settings, components, options.deck, comm));
    return ExitCode::Right;
  }
  return solveDeck(settings, options, components, comm, log, computed);
}

/// Large arrays come and go in every stage. Handing their pages back to the kernel and taking them again, zeroed, costs
/// a twentieth of a run.
void keepFreedMemory()
{
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

/// The processes of this run; none where they cannot be joined, which the first of them says.
std::optional<Comm> joinProcesses(int& argc, char**& argv)
{
  try {
    return Comm::world(argc, argv);
  } catch (const InputError& error) {
    if (launcherOfThisProcess().rank == 0)
      std::cerr << error.what() << "\n";
    finishMpi();
    return std::nullopt;
  }
}

/// `ndframe report NAME`: the page of files that are there.
ExitCode reportOn(const std::vector<std::string>& arguments, const Comm& comm)
{
  int code = 0;
  writeOnFirstRank(comm, [&] { code = runReport(arguments); });
  return code == 0 ? ExitCode::Right : (code == 1 ? ExitCode::Bug : ExitCode::UserInput);
}

/// `ndframe new TEMPLATE`: a deck to begin with.
ExitCode writeNew(const CommandLine& options, const Components& components, const Comm& comm, const Log& log)
{
  WrittenDeck written;
  writeOnFirstRank(comm, [&] { written = writeNewDeck(options.newDeck, components); });
  log.line(writtenText(written));
  for (const Diagnostic& mistake : written.mistakes)
    complain(comm, mistake.text());
  return written.mistakes.empty() ? ExitCode::Right : ExitCode::UserInput;
}

/// All that the command line asks for.
ExitCode obey(const CommandLine& options, const CLI::App& app, const Extension& extend, const Comm& comm,
              bool& computed)
{
  const Verbosity verbosity =
      options.quiet ? Verbosity::Quiet : (options.verbose ? Verbosity::Verbose : Verbosity::Normal);
  const Log log(std::cout, verbosity, comm.rank() == 0, mayDraw(STDOUT_FILENO, comm), patienceOf(options));
  const auto components = makeComponents(extend);
  if (const CLI::App* const wanted = app.get_subcommand("report"); wanted->parsed() && !options.help)
    return reportOn(wanted->remaining(), comm);
  if (app.get_subcommand("new")->parsed() && !options.help)
    return writeNew(options, *components, comm, log);
  beginTranscript(options, comm);
  std::ostream nobody(nullptr);
  if (answer(options, app, *components, comm, comm.rank() == 0 ? std::cout : nobody))
    return ExitCode::Right;
  return runInput(options, *components, comm, log, computed);
}

} // namespace

int runMain(int argc, char** argv, const Extension& extend)
{
  keepFreedMemory();
  prepareProcess();
  const std::optional<Comm> joined = joinProcesses(argc, argv);
  if (!joined)
    return int(ExitCode::UserInput);
  const Comm& comm = *joined;
  CommandLine options;
  CLI::App app("Certified unilateral contact between elastic bodies by Neumann-Dirichlet domain decomposition.",
               "ndframe");
  ExitCode code = ExitCode::Right;
  bool computed = false;
  try {
    declareOptions(app, options);
    app.parse(argc, argv);
    code = obey(options, app, extend, comm, computed);
  } catch (const CLI::ParseError& error) {
    complain(comm, fmt::format("ndframe: {}\n{}", error.what(), wayOut(argc, argv)));
    code = ExitCode::UserInput;
  } catch (...) {
    code = report(currentFailure(), computed, comm);
  }
  code = checkScreen(code, comm);
  finishMpi();
  return int(code);
}

} // namespace ndframe
