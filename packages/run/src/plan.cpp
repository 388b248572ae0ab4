#include "ndframe/run/plan.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/certification/error_options.hpp"
#include "ndframe/run/accuracy_options.hpp"

namespace ndframe
{
namespace
{

/// "1 body", "2 bodies".
std::string counted(std::size_t number, const std::string& one, const std::string& several)
{
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

/// True if a body's mesh is a script that the gmsh library has to mesh; mesh files are read without it.
bool meshesByGmsh(const Params& deck)
{
  const auto bodies = deck.sub("Bodies").subs();
  return std::any_of(bodies.begin(), bodies.end(), [](const Params& body) {
    const Params mesh = body.sub("Mesh");
    return mesh.get<std::string>("Type") == "Gmsh" &&
           std::filesystem::path(mesh.get<std::string>("File")).extension() == ".geo";
  });
}

std::vector<std::string> measureNames(const ErrorOptions& options)
{
  std::vector<std::string> names;
  for (const auto estimator : options.estimators)
    if (estimator != Estimator::Reference)
      names.push_back(estimatorNames().name(estimator));
  return names;
}

std::string refinementOf(const Params& accuracy)
{
  return fmt::format("{} sizes, by {}", accuracy.sub("Marking").get<std::string>("Type"),
                     accuracy.sub("Refinement").get<std::string>("Type"));
}

} // namespace

Plan::Plan(const Params& deck, const LinearSolver& solver, int ranks)
{
  const auto bodies = deck.sub("Bodies").subs().size(), interfaces = deck.sub("Interfaces").subs().size();
  const Params output = deck.sub("Output");
  const bool touches = interfaces > 0, exodus = output.get<bool>("Exodus");
  const std::string noInterface = "the deck has no interface";
  add("gmsh", meshesByGmsh(deck), "a body's mesh is a .geo script", "no .geo script: the library is not loaded");
  add("mpi", ranks > 1 || solver.needsMpi(ranks),
      fmt::format("{}, linear solver {}", counted(std::size_t(ranks), "process", "processes"), solver.name(ranks)),
      "one process: MPI is not started");
  add("krylov", deck.sub("Linear Solver").get<std::string>("Type") == "Krylov",
      "linear solver Krylov: Tpetra, Belos and their like are loaded", "no linear solver Krylov: Tpetra is not loaded");
  const bool toTarget = wantsAccuracy(deck);
  const std::string again = toTarget ? ", on every level" : "";
  add("read", true, counted(bodies, "body", "bodies") + again, {});
  add("check", true, "sides, pairing and supports are checked before anything is assembled" + again, {});
  add("assemble", true, counted(bodies, "matrix", "matrices") + again, {});
  add("factor", true, fmt::format("once per body, {} in all ({}){}", bodies, solver.name(ranks), again), {});
  add("interface", touches, counted(interfaces, "interface", "interfaces") + " condensed" + again, noInterface);
  add("couple", touches, deck.sub("Coupling").get<std::string>("Type") + again, noInterface);
  add("recover", true, "interior displacements, one back-solve a body and state" + again, {});
  addCertificate(deck);
  add("refine", toTarget, toTarget ? refinementOf(deck.sub("Accuracy")) : "", "the deck has no list Accuracy");
  add("stress", exodus, "for the Exodus file", "no Exodus file is written");
  const bool contact = touches && output.get<bool>("Contact Table");
  const bool levels = toTarget && output.get<bool>("Level Table");
  add("write", exodus || contact || levels || output.get<bool>("Summary"),
      fmt::format("to {}", output.get<std::string>("Directory")), "no file of this solution is asked for");
  add("level table", levels, "NAME.levels.csv", toTarget ? "switched off in Output" : "the deck has no list Accuracy");
  add("write levels", toTarget && output.get<bool>("All Levels"), "NAME.level-01.e, ... after every level",
      toTarget ? "Output does not ask for All Levels" : "the deck has no list Accuracy");
  add("contact table", contact, "NAME.contact.csv", touches ? "switched off in Output" : noInterface);
  const auto expected = deck.sub("Expect").subs().size();
  add("expect", expected > 0, counted(expected, "number", "numbers"), "the deck expects nothing");
}

void Plan::addCertificate(const Params& deck)
{
  const bool estimates = estimatesErrors(deck);
  add("certificate", estimates,
      wantsAccuracy(deck) ? "the bound on every level, all else on the last one" : "the error of the final state",
      "the deck has no list Error Estimation");
  if (!estimates)
    return;
  const ErrorOptions options = errorOptions(deck);
  const std::string noTraction =
      options.touches ? "no estimator needs an admissible traction" : "the deck has no interface";
  const std::string noStress = "no estimator needs an equilibrated stress";
  const auto measures = measureNames(options);
  add(certificateStage::traction, options.needsTraction(), tractionTypeNames().name(options.tractionType), noTraction);
  add(certificateStage::fields, options.needsTraction(), "in equilibrium with it, with the existing factors",
      noTraction);
  add(certificateStage::recovery, options.recoversStress(),
      deck.sub("Error Estimation").sub("Recovery").get<std::string>("Type"), noStress);
  add(certificateStage::equilibrium, options.checkEquilibrium, "Check Equilibrium", "Check Equilibrium is off");
  add(certificateStage::estimators, !measures.empty(), fmt::format("{}", fmt::join(measures, ", ")), "only Reference");
  add(certificateStage::reference, options.wants(Estimator::Reference),
      fmt::format("every edge halved {} times, at most {} dofs", options.refinements, options.maximumDofs),
      "Estimators does not name Reference");
}

void Plan::add(std::string name, bool runs, std::string whyRuns, std::string whySkipped)
{
  stages_.push_back({std::move(name), runs, runs ? std::move(whyRuns) : std::move(whySkipped)});
}

bool Plan::runs(const std::string& stage) const
{
  for (const auto& planned : stages_)
    if (planned.name == stage)
      return planned.runs;
  throw InternalError("no stage \"" + stage + "\" in the plan");
}

std::string Plan::text() const
{
  std::string text = fmt::format("  {:<19} {:<6} {}\n", "stage", "", "why");
  for (const auto& stage : stages_)
    text += fmt::format("  {:<19} {:<6} {}\n", stage.name, stage.runs ? "run" : "skip", stage.why);
  text.pop_back();
  return text;
}

} // namespace ndframe
