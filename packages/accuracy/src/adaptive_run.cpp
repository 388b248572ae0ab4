#include <fmt/format.h>

#include "accuracy_limits.hpp"
#include "level_loop.hpp"
#include "ndframe/accuracy/first_meshes.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/run/contact_start.hpp"
#include "ndframe/run/energy_comparison.hpp"
#include "ndframe/run/run_steps.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// By the deck, which has to say how errors are estimated.
const std::vector<Estimator>& estimatorsOf(const RunTools& tools)
{
  NDFRAME_ASSERT(tools.errors && tools.settings.accuracy, "a target needs the lists Accuracy and Error Estimation");
  return tools.errors->estimators;
}

} // namespace

AdaptiveRun::AdaptiveRun(RunTools tools, const AccuracyComponents& components, RunObserver& observer,
                         const LevelObserver& onLevel, EnergyRecords energies, const Restart& restart)
    : components_(components), observer_(observer), onLevel_(onLevel), restart_(restart), tools_(std::move(tools)),
      options_(*tools_.settings.accuracy), wanted_(estimatorsOf(tools_)),
      transfer_(components.contactTransfers.build(options_.lists.transfer)),
      stopping_(components.levelStoppings.build(options_.lists.stopping)), balances_(stopping_->allowed(1.0, 1.0) > 0.0)
{
  tools_.errors->estimators = {Estimator::Global};                                   // all that a level needs
  const double ofDisplacement = options_.of == AccuracyOf::Displacement ? 1.0 : 2.0; // the mean stress is half as wrong
  tools_.errors->enough = {ofDisplacement * options_.target, options_.relative};
  run_.startSeconds = wallSeconds();
  run_.energies = std::move(energies);
  run_.plan = Plan(tools_.settings, *tools_.solver, tools_.comm.size());
  summary_.of = accuracyOfNames().name(options_.of);
  summary_.target = options_.target;
  summary_.relative = options_.relative;
}

Run AdaptiveRun::run(Model known)
{
  const SerialBlas serial;
  if (restart_.from)
    refuseOtherDeck(restart_, tools_.settings);
  begin(std::move(known));
  bool goesOn = true;
  if (restart_.from)
    goesOn = resume(*restart_.from);
  else
    attempt(run_, observer_, [&] { solveLevel(); });
  while (goesOn && needsAnother())
    goesOn = takeNext();
  if (!summary_.reached && best_.level > 0 && !run_.contradiction)
    returnToBest();
  return finish();
}

void AdaptiveRun::begin(Model model)
{
  planner_ = readFirstMeshes(model, tools_, components_);
  saysShares_ = !shareLevel(model, planner_->meshes(), tools_);
  beginLevel(std::move(model), {});
  observer_.header(run_.summary, run_.model, tools_.coupling->roles() != Roles::Automatic);
}

bool AdaptiveRun::needsAnother()
{
  if (!run_.certificate || !run_.failure.empty())
    return false;
  const LevelErrors errors(run_, options_);
  LevelLesson lesson = lessonOf(run_, errors, tools_.comm);
  planner_->learn(uncutMeshes(), lesson);
  record(errors, std::move(lesson));
  summary_.reached = errors.reached() && !run_.contradiction && !lostGuarantee(summary_.levels);
  if (run_.contradiction)
    summary_.limit = contradictingText(*run_.contradiction);
  else if (!summary_.reached)
    summary_.limit = endOfProgress(options_, summary_.levels, run_.solved.coupling);
  if (!summary_.limit.empty() && !run_.contradiction && run_.solved.coupling.converged)
    keepCheckpoint();
  return !summary_.reached && summary_.limit.empty();
}

bool AdaptiveRun::takeNext()
{
  if (const auto failure = failureIn(tools_.comm, [&] { refine(); }))
    endWith(*failure);
  if (!summary_.limit.empty()) {
    keepCheckpoint();
    return false;
  }
  if (restart_.write) {
    const auto timer = timeStage(tools_.ledger, Stage::Write);
    restart_.write(levelCheckpoint());
  }
  return solveNext();
}

bool AdaptiveRun::solveNext()
{
  const auto failure = failureIn(tools_.comm, [&] {
    readLevel(planner_->meshes(), run_.model.interfaces);
    attempt(run_, observer_, [&] { solveLevel(); });
  });
  if (failure)
    endWith(*failure);
  return summary_.limit.empty();
}

void AdaptiveRun::endWith(const Failure& failure)
{
  summary_.limit =
      fmt::format("level {}: {}", summary_.levels.size() + 1, failure.outOfMemory ? needsMoreMemory : failure.text);
  if (failure.code == ExitCode::Bug)
    run_.bug = failure.text;
  run_.certificate.reset(); // what is left may be half of a level
  run_.condensed = {};
}

void AdaptiveRun::readLevel(const std::vector<Mesh>& meshes, const std::vector<InterfaceMesh>& before)
{
  Model model;
  model.interfaces = run_.model.interfaces;
  auto next = meshes.begin();
  if (!shareLevel(model, meshes, tools_))
    readModel(model, tools_, [&](const BodySettings& body) { return body.isRigid ? Mesh() : *next++; });
  beginLevel(std::move(model), before);
}

/// The bodies have the roles of the level before, until its own are found.
void AdaptiveRun::beginLevel(Model&& model, const std::vector<InterfaceMesh>& before)
{
  std::vector<RoleSummary> roles = rolesOf(run_);
  if (!roles.empty())
    orientLike(model, before);
  run_.model = std::move(model);
  run_.summary = outlineSummary(run_.model, tools_.settings, *tools_.solver, tools_.comm.size());
  if (!roles.empty())
    run_.summary.coupling->roles = std::move(roles);
  run_.certificate.reset();
  run_.level = int(summary_.levels.size()) + 1;
  sweeps_ = 0;
  tools_.ledger.tell(Depth::Level, progress());
}

/// The level that begins, and how small the bound was on the one before.
Progress AdaptiveRun::progress() const
{
  if (summary_.levels.empty())
    return {"level", run_.level};
  const LevelSummary& last = summary_.levels.back();
  return Progress::falling("level", run_.level, "bound", options_.relative ? last.relative : last.bound,
                           options_.target);
}

void AdaptiveRun::record(const LevelErrors& errors, LevelLesson&& lesson)
{
  LevelSummary level = summarizeLevel(run_, uncutMeshes(), lesson, tools_.comm);
  level.level = int(summary_.levels.size()) + 1;
  level.sweeps = sweeps_;
  level.dofsToTarget = errors.reached() || !errors.tells() ? 0 : planner_->dofsToTarget().value_or(0);
  level.seconds = largestOf(wallSeconds() - run_.startSeconds);
  const CarriedContact contact = contactOf(run_, run_.solved.coupling.state.tractionNeumann);
  enter(level, contact);
  errors_ = errors;
  next_ = contactOf(run_, nextTraction(run_));
  if (restart_.write)
    done_.push_back(recordOf(level, std::move(lesson), contact));
  if (onLevel_)
    onLevel_(run_, level.level);
}

void AdaptiveRun::enter(const LevelSummary& level, const CarriedContact& contact)
{
  if (summary_.levels.empty())
    observer_.levels(summary_, balances_ && tools_.settings.namesTolerance);
  summary_.levels.push_back(level);
  observer_.level(level, noteOfLevel());
  if (best_.level == 0 || isBetter(level, summary_.levels[std::size_t(best_.level) - 1]))
    best_ = {level.level, planner_->meshes(), contact, rolesOf(run_)};
}

std::vector<const Mesh*> AdaptiveRun::uncutMeshes() const
{
  std::vector<const Mesh*> meshes;
  for (const int b : run_.model.elasticBodies()) {
    const BodyModel& body = run_.model.bodies[std::size_t(b)];
    meshes.push_back(body.share ? &planner_->meshes()[meshes.size()] : &body.uncut());
  }
  return meshes;
}

double AdaptiveRun::largestOf(double value) const
{
  Vector values{value};
  takeLargest(values, tools_.comm);
  return values[0];
}

void AdaptiveRun::refine()
{
  const auto timer = timeStage(tools_.ledger, Stage::Refine);
  MeshPlan plan = planner_->nextStep(options_.maximumDofs);
  const double growth = double(plan.dofs) / double(summary_.levels.back().dofs);
  const double used = double(std::max(earlierMemory_, peakMemory()) - firstMemory_);
  summary_.limit = limitMet(options_, summary_.levels, plan.dofs, largestOf(double(firstMemory_) + growth * used));
  if (summary_.limit.empty() && plan.meshes->areUnchanged() && plan.dofs == summary_.levels.back().dofs)
    summary_.limit = "cells are as small as their coordinates can resolve";
  if (!summary_.limit.empty())
    return;
  if (restart_.write)
    done_.back().maximumDofs = options_.maximumDofs;
  carryOver(std::move(plan));
}

void AdaptiveRun::carryOver(MeshPlan plan)
{
  expectedMesh_ = plan.bound / errors_->bound * errors_->mesh;
  expectsTarget_ = plan.bound <= errors_->target;
  planner_->accept(std::move(plan));
  carried_ = std::move(next_);
  if (carriesSolution()) // else it may be of a checkpoint
    solution_ = CarriedSolution(run_);
}

/// A level may end with a larger bound than one before, or without any: then that one is computed again. One sweep
/// from its Neumann traction is its state.
void AdaptiveRun::returnToBest()
{
  const bool isLast = best_.level == int(summary_.levels.size());
  if (isLast && run_.certificate && run_.failure.empty() && !isLoose_)
    return;
  if (summary_.limit.empty())
    summary_.limit = run_.failure.empty() ? run_.solved.coupling.reason : run_.failure;
  run_.failure.clear();
  if (run_.summary.coupling)
    run_.summary.coupling->roles = best_.roles;
  attempt(run_, observer_, [&] {
    if (const auto failure = failureIn(tools_.comm, [&] { solveBestAgain(); }))
      throw NotConverged(fmt::format("the answer of level {} could not be computed again: {}", best_.level,
                                     failure->outOfMemory ? needsMoreMemory : failure->text));
  });
}

void AdaptiveRun::solveBestAgain()
{
  if (best_.level == int(summary_.levels.size()) && run_.certificate) {
    SweepsRecord before;
    before.before = sweeps_;
    solveFrom(presentState(), before);
    return;
  }
  readLevel(best_.meshes, best_.contact.interfaces);
  condenseRun(run_, tools_, silent_);
  CouplingStart start = startFrom(run_, best_.contact);
  start.iterationError = std::numeric_limits<double>::max();
  solveRun(run_, tools_, silent_, start);
  certifyRun(run_, tools_);
}

/// The whole certificate of the last level, if the deck asks for more than the bound; the summary.
Run AdaptiveRun::finish()
{
  if (run_.certificate && wanted_ != tools_.errors->estimators) {
    tools_.errors->estimators = wanted_;
    certifyRun(run_, tools_);
  }
  summary_.written = summary_.reached || run_.contradiction ? int(summary_.levels.size()) : best_.level;
  run_.summary.accuracy = summary_;
  finishRun(run_, tools_);
  if (!summary_.reached && summary_.limit.empty())
    run_.summary.accuracy->limit = run_.failure;
  return std::move(run_);
}

Run runToTarget(RunTools tools, const AccuracyComponents& components, RunObserver& observer,
                const LevelObserver& onLevel, EnergyRecords energies, Model known, const Restart& restart)
{
  return AdaptiveRun(std::move(tools), components, observer, onLevel, std::move(energies), restart)
      .run(std::move(known));
}

} // namespace ndframe
