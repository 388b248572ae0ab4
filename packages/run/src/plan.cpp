#include "ndframe/run/plan.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/grouped.hpp"
#include "shared_run.hpp"

namespace ndframe
{
namespace
{

/// "1 body", "2 bodies".
std::string counted(std::size_t number, const std::string& one, const std::string& several)
{
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

std::vector<std::string> measureNames(const ErrorOptions& options)
{
  std::vector<std::string> names;
  for (const auto estimator : options.estimators)
    if (estimator != Estimator::Reference)
      names.push_back(estimatorNames().name(estimator));
  return names;
}

std::string refinementOf(const AccuracyOptions& accuracy)
{
  return fmt::format("{} sizes, by {}", accuracy.marking, accuracy.refinement);
}

bool iterates(const std::string& linearSolver)
{
  return linearSolver == "Krylov" || linearSolver == "Multigrid";
}

std::string krylovSkipped(bool choosesSolver)
{
  return choosesSolver ? "no iterative linear solver is named: Tpetra is loaded for large solids alone"
                       : "neither Krylov nor Multigrid as linear solver: Tpetra is not loaded";
}

/// What Automatic takes instead where it has to.
std::string largeText(bool choosesSolver)
{
  return choosesSolver ? ", Multigrid for large solids" : "";
}

std::string processesText(int ranks, const std::string& solver, bool choosesSolver)
{
  return fmt::format("{}, linear solver {}{}", counted(std::size_t(ranks), "process", "processes"), solver,
                     largeText(choosesSolver));
}

std::string sharesText(const RunSettings& settings, int ranks)
{
  return mayBeShared(settings, ranks) ? "; where Multigrid solves solids whole, each process has its share of them"
                                      : "";
}

/// How several processes share the fields' file.
std::string fieldsText(ExodusFiles files, int ranks)
{
  std::string text = "for the Exodus file";
  if (ranks > 1 && files != ExodusFiles::Single)
    text += fmt::format(", in {} pieces", ranks);
  if (ranks > 1 && files == ExodusFiles::Automatic)
    text += fmt::format(" from {} nodes on", grouped(leastNodesInPieces));
  return text;
}

} // namespace

Plan::Plan(const RunSettings& settings, const LinearSolver& solver, int ranks)
{
  const std::size_t bodies = settings.outline.bodies, interfaces = settings.outline.interfaces;
  const OutputOptions& output = settings.output;
  const bool touches = interfaces > 0, toTarget = settings.accuracy.has_value(), exodus = output.exodus,
             chooses = settings.linearSolver == "Automatic";
  const std::string noInterface = "the deck has no interface";
  add(Stage::Gmsh, settings.outline.needsGmsh, "a body's mesh is a .geo script",
      "no .geo script: the library is not loaded");
  add(Stage::Mpi, ranks > 1 || solver.needsMpi(ranks), processesText(ranks, solver.name(ranks), chooses),
      chooses ? "one process: MPI is started for large solids alone" : "one process: MPI is not started");
  add(Stage::Krylov, iterates(settings.linearSolver),
      fmt::format("linear solver {}: Tpetra, Belos and the like are loaded", settings.linearSolver),
      krylovSkipped(chooses));
  const std::string again = toTarget ? ", on every level" : "";
  add(Stage::Read, true, counted(bodies, "body", "bodies") + again + sharesText(settings, ranks), {});
  add(Stage::Check, true, "sides, pairing and supports are checked before anything is assembled" + again, {});
  add(Stage::Assemble, true, counted(bodies, "matrix", "matrices") + again, {});
  add(Stage::Factor, true,
      fmt::format("once per body, {} in all ({}{}){}", bodies, solver.name(ranks), largeText(chooses), again), {});
  const std::string met = settings.outline.findsInterfaces ? "interfaces as Automatic finds them"
                                                           : counted(interfaces, "interface", "interfaces");
  add(Stage::Interface, touches, met + " condensed" + again, noInterface);
  add(Stage::Couple, touches, settings.coupling + again, noInterface);
  add(Stage::Recover, true, "interior displacements, one back substitution per body and state" + again, {});
  addCertificate(settings);
  add(Stage::Refine, toTarget, toTarget ? refinementOf(*settings.accuracy) : "", "the deck has no list Accuracy");
  add(Stage::Stress, exodus, fieldsText(output.exodusFiles, ranks), "no Exodus file is written");
  const bool contact = touches && output.contactTable;
  const bool levels = toTarget && output.levelTable;
  add(Stage::Write, exodus || contact || levels || output.summary || output.probeTable || output.checkpoint,
      fmt::format("to {}", output.directory), "no file of this solution is asked for");
  add(Stage::LevelTable, levels, "NAME.levels.csv",
      toTarget ? "switched off in Output" : "the deck has no list Accuracy");
  add(Stage::WriteLevels, toTarget && output.allLevels, "NAME.level-01.e, ... after every level",
      toTarget ? "Output does not ask for All Levels" : "the deck has no list Accuracy");
  add(Stage::ContactTable, contact, "NAME.contact.csv", touches ? "switched off in Output" : noInterface);
  const auto expected = settings.expectations.size();
  add(Stage::Expect, expected > 0, counted(expected, "number", "numbers"), "the deck expects nothing");
}

void Plan::addCertificate(const RunSettings& settings)
{
  const bool estimates = settings.errors.has_value();
  add(Stage::Certificate, estimates,
      settings.accuracy ? "the bound on every level, all else on the last one" : "the error of the final state",
      "the deck has no list Error Estimation");
  if (!estimates)
    return;
  const ErrorOptions& options = *settings.errors;
  const std::string noTraction =
      options.touches ? "no estimator needs an admissible traction" : "the deck has no interface";
  const std::string noStress = "no estimator needs an equilibrated stress";
  const auto measures = measureNames(options);
  add(Stage::CertifyTraction, options.needsTraction(), tractionTypeNames().name(options.tractionType), noTraction);
  add(Stage::CertifyFields, options.needsTraction(), "in equilibrium with it, with the existing factors", noTraction);
  add(Stage::CertifyRecovery, options.recoversStress(), options.recovery, noStress);
  add(Stage::CertifyEquilibrium, options.checkEquilibrium, "Check Equilibrium", "Check Equilibrium is off");
  add(Stage::CertifyEstimators, !measures.empty(), fmt::format("{}", fmt::join(measures, ", ")), "only Reference");
  add(Stage::CertifyReference, options.wants(Estimator::Reference),
      fmt::format("every edge halved {} times", options.refinements) +
          (options.maximumDofs > 0 ? fmt::format(", at most {} dofs", options.maximumDofs) : ""),
      "Estimators does not name Reference");
}

void Plan::add(Stage stage, bool runs, std::string whyRuns, std::string whySkipped)
{
  stages_.push_back({stage, runs, runs ? std::move(whyRuns) : std::move(whySkipped)});
}

bool Plan::runs(Stage stage) const
{
  for (const auto& planned : stages_)
    if (planned.stage == stage)
      return planned.runs;
  throw InternalError("no stage \"" + stageNames().name(stage) + "\" in the plan");
}

std::string Plan::text() const
{
  std::string text = fmt::format("  {:<19} {:<6} {}\n", "stage", "", "why");
  for (const auto& stage : stages_)
    text += fmt::format("  {:<19} {:<6} {}\n", stageNames().name(stage.stage), stage.runs ? "run" : "skip", stage.why);
  text.pop_back();
  return text;
}

} // namespace ndframe
