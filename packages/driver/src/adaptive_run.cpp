#include "adaptive_run.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "accuracy_limits.hpp"
#include "accuracy_screen.hpp"
#include "coarsest_meshes.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/interface/traction_transfer.hpp"
#include "roles.hpp"
#include "run_steps.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

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

/// The level with the smallest bound so far.
struct Best
{
  int level = 0; ///< from 1; 0: none
  std::vector<Mesh> meshes;
  CarriedContact contact; ///< with the Neumann traction
};

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
      summary_.limit = endOfProgress(options_, summary_.levels, run_.coupling);
      if (!summary_.limit.empty() || !refine(errors))
        break;
      readLevel(planner_->meshes());
    }
    if (!summary_.reached && best_.level > 0)
      returnToBest();
    return finish();
  }

private:
  void begin()
  {
    Model model;
    planner_ = readFirstMeshes(model, tools_);
    beginLevel(std::move(model));
    log_.line(headerText(run_.summary, run_.model, tools_.coupling->roles() != Roles::Automatic));
  }

  void readLevel(const std::vector<Mesh>& meshes)
  {
    Model model;
    model.interfaces = run_.model.interfaces;
    readModel(model, tools_,
              [&](const Params& body) { return meshes[std::size_t(run_.model.bodyIndex(body.name()))]; });
    beginLevel(std::move(model));
  }

  /// Automatic roles are those of the first level.
  void beginLevel(Model&& model)
  {
    std::vector<RoleSummary> roles;
    if (run_.summary.coupling)
      roles = run_.summary.coupling->roles;
    if (!roles.empty())
      orientLike(model, run_.model);
    run_.model = std::move(model);
    run_.summary = outlineSummary(run_.model, deck_, *tools_.solver, tools_.comm.size());
    if (!roles.empty())
      run_.summary.coupling->roles = std::move(roles);
    run_.certificate.reset();
    sweeps_ = 0;
  }

  /// Sweeps until their part is small beside the mesh's, and the certificate of that state.
  void solveLevel()
  {
    condenseRun(run_, tools_, summary_.levels.empty() ? log_ : silentLog());
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
    if (summary_.levels.empty())
      log_.line("\n" + levelTitle(summary_, stoppingText(deck_, balances_)));
    summary_.levels.push_back(level);
    log_.line(levelLine(level));
    if (best_.level == 0 || level.bound < summary_.levels[std::size_t(best_.level) - 1].bound)
      best_ = {level.level, planner_->meshes(), contactOf(run_.coupling.state.tractionNeumann)};
    if (onLevel_)
      onLevel_(run_, level.level);
  }

  /// Plans the next meshes; false when they do not fit into the limits.
  bool refine(const LevelErrors& errors)
  {
    const auto timer = tools_.ledger.time("refine");
    MeshPlan plan = planner_->nextStep(options_.maximumDofs);
    summary_.limit = limitMet(options_, summary_.levels, plan.dofs, firstMemory_);
    if (!summary_.limit.empty())
      return false;
    carryOver(errors, std::move(plan));
    return true;
  }

  void carryOver(const LevelErrors& errors, MeshPlan plan)
  {
    expectedMesh_ = plan.bound / errors.bound * errors.mesh;
    planner_->accept(std::move(plan));
    if (!run_.model.interfaces.empty())
      carried_ = contactOf(nextTraction(run_.condensed.interface, run_.coupling));
  }

  CarriedContact contactOf(Vector traction) const
  {
    if (run_.model.interfaces.empty())
      return {};
    return {run_.model.interfaces, std::move(traction),
            statusesOfNodes(run_.condensed.interface, run_.coupling.state.closed)};
  }

  /// A level may end with a larger bound than one before, or without any: then that one is computed again. One sweep
  /// from its Neumann traction is its state.
  void returnToBest()
  {
    const bool isLast = best_.level == int(summary_.levels.size());
    if (isLast && run_.certificate && run_.failure.empty())
      return;
    if (summary_.limit.empty())
      summary_.limit = run_.failure.empty() ? run_.coupling.reason : run_.failure;
    run_.failure.clear();
    readLevel(best_.meshes);
    attempt(run_, log_, [&] {
      condenseRun(run_, tools_, silentLog());
      CouplingStart start;
      start.iterationError = std::numeric_limits<double>::max();
      if (!best_.contact.interfaces.empty()) {
        start.traction = best_.contact.traction;
        start.closed = statusesOfUnknowns(run_.condensed.interface, best_.contact.closed);
      }
      solveRun(run_, tools_, silentLog(), start);
      certifyRun(run_, tools_);
    });
  }

  /// The whole certificate of the last level, if the deck asks for more than the bound; the summary.
  Run finish()
  {
    if (run_.certificate && wanted_ != tools_.errors->estimators) {
      tools_.errors->estimators = wanted_;
      certifyRun(run_, tools_);
    }
    summary_.written = summary_.reached ? int(summary_.levels.size()) : best_.level;
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
  Best best_;
  int sweeps_ = 0;                                  ///< of this level
  const double firstMemory_ = double(peakMemory()); ///< bytes, before there was a mesh
  AccuracySummary summary_;
};

} // namespace

MeshPlanner readFirstMeshes(Model& model, const RunTools& tools)
{
  checkLists(tools);
  const bool coarsest = accuracyOptions(tools.deck).start == AccuracyStart::Coarsest;
  readModel(model, tools, coarsest ? coarsestMeshes(tools.deck, tools.components, tools.comm) : MeshOfBody());
  if (model.bodies.front().mesh.dim == 3)
    throw InputError(tools.deck.sub("Accuracy")
                         .mistake("", "meshes are adapted in two dimensions only; remove the list and choose the "
                                      "mesh."));
  return {tools.deck, tools.components, model, tools.comm};
}

Run runToTarget(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
                const LevelObserver& onLevel)
{
  RunTools tools(deck, components, comm, ledger);
  checkLists(tools);
  return AdaptiveRun(std::move(tools), log, onLevel).run();
}

} // namespace ndframe
