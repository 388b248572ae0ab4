#include "adaptive_run.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "accuracy_screen.hpp"
#include "coarsest_meshes.hpp"
#include "mesh_planner.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/interface/traction_transfer.hpp"
#include "run_steps.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

/// A bound that falls by less than this in two levels does not follow the mesh any more.
constexpr double stalled = 0.98;
/// Relative bounds below this may be nothing but round-off of the residuals, which stays when cells become smaller.
constexpr double roundOff = 1e-8;

/// A bound above that of the coarser mesh before is one of tractions that were left where contact opens, which the
/// energy of the iteration hardly sees: then the sweeps go on, as long as the bound falls by a tenth.
constexpr double falling = 0.9, oneMoreDigit = 0.1;

/// The traction that the next sweep would begin with, (27); none at open nodes, where what is left of earlier sweeps
/// decays slowly and costs the bound more than the iteration's part shows: traction times opening.
Vector nextTraction(const InterfaceSystem& system, const CouplingResult& coupling)
{
  const double theta = coupling.history.back().theta;
  const std::vector<char> closed = statusesOfNodes(system, coupling.state.closed);
  Vector traction = coupling.state.tractionNeumann;
  for (std::size_t i = 0; i < traction.size(); ++i)
    traction[i] = closed[i] ? traction[i] + theta * (coupling.state.tractionDirichlet[i] - traction[i]) : 0.0;
  return traction;
}

/// The loop of a run with a target: solve until the iteration is small beside the mesh, certify, stop or refine, carry
/// over.
class AdaptiveRun
{
public:
  AdaptiveRun(RunTools tools, const Log& log, const LevelObserver& onLevel)
      : deck_(tools.deck), log_(log), onLevel_(onLevel), tools_(std::move(tools)), options_(accuracyOptions(deck_)),
        wanted_(tools_.errors->estimators),
        transfer_(tools_.components.contactTransfers.build(deck_.sub("Accuracy").sub("Transfer"))),
        stopping_(tools_.components.levelStoppings.build(deck_.sub("Accuracy").sub("Stopping"))),
        balances_(balancesSweeps(deck_.sub("Accuracy"), tools_.components))
  {
    tools_.errors->estimators = {Estimator::Global}; // all that a level needs
    run_.startSeconds = wallSeconds();
    run_.plan = Plan(deck_, *tools_.solver, tools_.comm.size());
    summary_.of = accuracyOfNames().name(options_.of);
    summary_.target = options_.target;
    summary_.relative = options_.relative;
  }

  Run run()
  {
    const SerialBlas serial;
    begin();
    for (;;) {
      attempt(run_, log_, [&] { solveLevel(); });
      if (!run_.certificate || !run_.failure.empty())
        break;
      const LevelErrors errors(run_, options_);
      planner_->learn(run_, errors);
      record(errors);
      summary_.reached = errors.reached();
      if (summary_.reached)
        break;
      MeshPlan plan = planner_->nextStep(options_.maximumDofs);
      summary_.limit = limitMet(plan);
      if (!summary_.limit.empty())
        break;
      carryOver(errors, std::move(plan));
      Model model;
      readModel(model, tools_,
                [&](const Params& body) { return planner_->meshes()[std::size_t(run_.model.bodyIndex(body.name()))]; });
      beginLevel(std::move(model));
    }
    return finish();
  }

private:
  void begin()
  {
    Model model;
    readFirstMeshes(model, tools_);
    beginLevel(std::move(model));
    planner_.emplace(deck_, tools_.components, run_.model, tools_.comm);
    log_.line(headerText(run_.summary, run_.model, tools_.coupling->roles() != Roles::Automatic));
    log_.line("\n" + levelTitle(summary_, stoppingText(deck_, balances_)));
  }

  void beginLevel(Model&& model)
  {
    run_.model = std::move(model);
    run_.summary = outlineSummary(run_.model, deck_, *tools_.solver, tools_.comm.size());
    run_.certificate.reset();
    sweeps_ = 0;
  }

  /// Sweeps until their part is small beside the mesh's, and the certificate of that state.
  void solveLevel()
  {
    condenseRun(run_, tools_, silentLog());
    CouplingStart start = firstStart();
    const double unknown = std::numeric_limits<double>::infinity();
    for (double iterationBefore = unknown, boundBefore = unknown;;) {
      solveRun(run_, tools_, silentLog(), start);
      sweeps_ += int(run_.coupling.history.size());
      certifyRun(run_, tools_);
      if (!balances_ || !run_.certificate || !run_.coupling.converged)
        return;
      const LevelErrors errors(run_, options_);
      const double allowed = std::min(allowedIteration(errors.mesh), errors.iterationToTarget());
      const bool rises = !summary_.levels.empty() && errors.bound > summary_.levels.back().bound &&
                         errors.bound < falling * boundBefore;
      if (errors.iteration >= iterationBefore || errors.iteration == 0.0 || (errors.iteration <= allowed && !rises))
        return;
      start.traction = nextTraction(run_.condensed.interface, run_.coupling);
      start.closed = run_.coupling.state.closed;
      start.iterationError = errors.iteration > allowed ? allowed : oneMoreDigit * errors.iteration;
      iterationBefore = errors.iteration;
      boundBefore = errors.bound;
    }
  }

  CouplingStart firstStart() const
  {
    CouplingStart start;
    start.iterationError = allowedIteration(expectedMesh_);
    if (carried_.interfaces.empty())
      return start;
    const CarriedContact contact = transfer_->onto(run_.model.interfaces, carried_);
    start.traction = contact.traction;
    if (!contact.closed.empty())
      start.closed = statusesOfUnknowns(run_.condensed.interface, contact.closed);
    return start;
  }

  double allowedIteration(double mesh) const { return stopping_->allowed(mesh, options_.iterationShare); }

  void record(const LevelErrors& errors)
  {
    LevelSummary level = summarizeLevel(run_, errors);
    level.level = int(summary_.levels.size()) + 1;
    level.sweeps = sweeps_;
    level.dofsToTarget = errors.reached() ? 0 : planner_->dofsToTarget().value_or(0);
    level.seconds = wallSeconds() - run_.startSeconds;
    summary_.levels.push_back(level);
    log_.line(levelLine(level));
    if (onLevel_)
      onLevel_(run_, level.level);
  }

  /// Why no level follows; empty when one does.
  std::string limitMet(const MeshPlan& plan) const
  {
    const auto& levels = summary_.levels;
    if (!run_.coupling.converged && !run_.coupling.history.empty())
      return "the sweeps do not come to an end: " + run_.coupling.reason;
    if (int(levels.size()) >= options_.maximumLevels)
      return fmt::format("Maximum Levels = {}", options_.maximumLevels);
    if (levels.size() > 2 && levels.back().bound > stalled * levels[levels.size() - 3].bound)
      return levels.back().relative < roundOff ? "the bound does not fall with the mesh any more: round-off"
                                               : "the bound does not fall with the mesh any more";
    const double growth = double(plan.dofs) / double(levels.back().dofs);
    if (plan.dofs > options_.maximumDofs)
      return fmt::format("Maximum Dofs = {}", options_.maximumDofs);
    const double last = levels.back().seconds - (levels.size() > 1 ? levels[levels.size() - 2].seconds : 0.0);
    if (levels.back().seconds + growth * last > options_.maximumSeconds)
      return fmt::format("Maximum Time = {:g} s: the next mesh would take {:.2g} s", options_.maximumSeconds,
                         growth * last);
    if (growth * double(peakMemory()) > options_.maximumMemory)
      return fmt::format("Maximum Memory = {:g} GB: the next mesh would take some {:.2g} GB",
                         options_.maximumMemory * 1e-9, 1e-9 * growth * double(peakMemory()));
    return {};
  }

  void carryOver(const LevelErrors& errors, MeshPlan plan)
  {
    expectedMesh_ = plan.bound / errors.bound * errors.mesh;
    planner_->accept(std::move(plan));
    if (run_.model.interfaces.empty())
      return;
    carried_ = {run_.model.interfaces, nextTraction(run_.condensed.interface, run_.coupling),
                statusesOfNodes(run_.condensed.interface, run_.coupling.state.closed)};
  }

  /// The whole certificate of the last level, if the deck asks for more than the bound; the summary.
  Run finish()
  {
    if (run_.certificate && wanted_ != tools_.errors->estimators) {
      tools_.errors->estimators = wanted_;
      certifyRun(run_, tools_);
    }
    run_.summary.accuracy = summary_;
    finishRun(run_, tools_);
    if (!summary_.reached && summary_.limit.empty())
      run_.summary.accuracy->limit = run_.failure;
    return std::move(run_);
  }

  const Params& deck_;
  const Log& log_;
  const LevelObserver& onLevel_;
  RunTools tools_;
  const AccuracyOptions options_;
  const std::vector<Estimator> wanted_; ///< by the deck
  Run run_;
  const std::unique_ptr<ContactTransfer> transfer_;
  const std::unique_ptr<LevelStopping> stopping_;
  const bool balances_;
  std::optional<MeshPlanner> planner_;
  double expectedMesh_ = std::numeric_limits<double>::max(); ///< the mesh's part on the next level; unknown at first
  CarriedContact carried_;
  int sweeps_ = 0; ///< of this level
  AccuracySummary summary_;
};

} // namespace

void readFirstMeshes(Model& model, const RunTools& tools)
{
  checkLists(tools);
  const bool coarsest = accuracyOptions(tools.deck).start == AccuracyStart::Coarsest;
  readModel(model, tools, coarsest ? coarsestMeshes(tools.deck, tools.components, tools.comm) : MeshOfBody());
  if (model.bodies.front().mesh.dim == 3)
    throw InputError(tools.deck.sub("Accuracy")
                         .mistake("", "meshes are adapted in two dimensions only; remove the list and choose the "
                                      "mesh."));
}

Run runToTarget(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
                const LevelObserver& onLevel)
{
  RunTools tools(deck, components, comm, ledger);
  checkLists(tools);
  return AdaptiveRun(std::move(tools), log, onLevel).run();
}

} // namespace ndframe
