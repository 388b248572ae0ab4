#include "command_line.hpp"

#include <map>

#include <fmt/format.h>

#include "shell_files.hpp"

namespace ndframe
{

namespace
{

/// What is answered without a deck.
void declareQuestions(CLI::App& app, CommandLine& options)
{
  app.add_option_function<std::string>(
         "-h,--help", [&options](const std::string& list) { options.help = list; },
         "This text, or the documentation of a list or component of the deck; other words: where they are named.")
      ->type_name("WORD")
      ->expected(0, 1)
      ->default_str("");
  app.add_flag("--list", options.list, "All components by list.");
  app.add_flag("--dump-defaults", options.dumpDefaults, "A deck that runs, with every parameter and its default.");
  app.add_flag("--reference", options.reference, "The whole deck reference as Markdown (docs/reference.md).");
  app.add_option(
         "--completion", options.completion,
         "A script that completes options, lists and parameters, for bash, zsh or fish; installed with ndframe.")
      ->type_name("SHELL");
  app.add_flag("--man", options.manual, "The manual page, in roff; installed with ndframe.");
  app.add_flag("--version", options.version, "The version, commit, build type, libraries, threads and processes.");
}

/// What is shown, and where.
void declareScreen(CLI::App& app, CommandLine& options)
{
  app.add_flag("-q,--quiet", options.quiet, "Show only warnings and errors on the screen.");
  app.add_flag("-v,--verbose", options.verbose, "More: ordering, size of the factors.");
  app.add_option("--log", options.logFile,
                 "Also write all that the screen shows to a file, with a line \"# TIME STAGE\" where a stage begins. "
                 "With -q the file gets what the screen would show without -q.")
      ->type_name("FILE");
  app.add_option("--live", options.live,
                 "How long without output before a line shows the current step and its progress; 0: never. By default "
                 "1 on a terminal, where the line is erased again, and 10 elsewhere.")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 1e6));
}

void declareNew(CLI::App& app, CommandLine& options)
{
  CLI::App& one = *app.add_subcommand("new", "Write a commented deck that runs, as a start.");
  one.set_help_flag();
  one.add_flag_callback(
      "-h,--help", [&options] { options.help = ""; }, "This text.");
  one.add_option("template", options.newDeck.name, "Which one, see below.")->type_name("TEMPLATE");
  one.add_option("file", options.newDeck.drawing, "For from-geo: a gmsh drawing or mesh, .geo or .msh.")
      ->type_name("FILE");
  one.add_option("-o,--output", options.newDeck.output, "Instead of TEMPLATE.xml, or of the drawing's name with .xml.")
      ->type_name("DECK");
  one.add_flag("-f,--force", options.newDeck.replace, "Replace a file that exists already.");
}

} // namespace

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
  app.add_option("--study", options.axes,
                 "Run the deck for every value of a parameter, one CSV row per case, e.g. --study "
                 "\"Coupling/Stopping/Tolerance=0.1; 0.01\"; repeated, every combination. Parameters joined by \"&&\" "
                 "vary together.")
      ->type_name("PATH=VALUE;VALUE")
      ->expected(1)
      ->take_all();
  app.add_flag("--check", options.check, "Check everything, mesh files included, and stop before the solve.");
  app.add_flag("--plan", options.plan, "Show the stages that this deck will run, those it skips, and why.");
  app.add_flag(
      "--yardstick", options.yardstick,
      "Only order, factor and solve each body once with METIS and CHOLMOD: what a run's speed is compared with.");
  app.add_option(
         "--decompose", options.decompose,
         "Only write the meshes of all bodies as N pieces each, NAME.BODY.e.N.r, and show the settings with which "
         "the deck reads them.")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  app.add_flag("--restart", options.restart,
               "Continue an interrupted run from NAME.checkpoint, which Output/Checkpoint writes.");
  declareQuestions(app, options);
  declareScreen(app, options);
  declareNew(app, options);
  app.add_subcommand("report", "Write NAME.report.html, one page with everything that a run or a study has written "
                               "(`ndframe report --help`).")
      ->prefix_command()
      ->set_help_flag();
}

std::string wayOut(int argc, const char* const* argv)
{
  static const std::map<std::string, std::string> meant{{"run", "ndframe"},
                                                        {"solve", "ndframe"},
                                                        {"check", "ndframe --check"},
                                                        {"plan", "ndframe --plan"},
                                                        {"from-geo", "ndframe new from-geo"}};
  const auto found = argc > 2 ? meant.find(argv[1]) : meant.end();
  return found == meant.end() ? "`ndframe --help` shows the options."
                              : fmt::format("Did you mean: {} {}", found->second, forShell(argv[2]));
}

const char* exitCodeText()
{
  return "\nExit codes: 0 success, 1 a bug, 2 wrong input, 3 not converged, or a bound without the guarantee that the "
         "deck requires, or no certificate (results are written and marked; without a solution only the summary), 4 an "
         "expectation missed, 5 the target of the list Accuracy missed (the best answer is written with its bound), 6 "
         "the answer has warnings and the deck's Strict Input forbids them (results are written).\n";
}

} // namespace ndframe
