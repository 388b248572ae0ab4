#include "ndframe/run/run_steps.hpp"

#include <utility>

#include <fmt/format.h>

#include "check_model.hpp"
#include "field_names.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/condensation/trust.hpp"
#include "ndframe/run/energy_comparison.hpp"
#include "ndframe/run/memory_plan.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/run/warnings.hpp"
#include "ndframe/scene/rigid_check.hpp"
#include "ndframe/scene/stage.hpp"
#include "shared_run.hpp"
#include "verdict.hpp"

namespace ndframe
{
namespace
{

/// Why a step could not be done, where that lies in the problem; empty when it is done.
template <class Step>
std::string failureOf(const Step& step)
{
  try {
    step();
    return {};
  } catch (const NotConverged& failure) {
    return failure.what();
  } catch (const SingularBody& failure) { // met by an iterative solver on its way
    return failure.what();
  } catch (const NotPositiveDefinite&) {
    return "a body's stiffness on the interface is lost in round-off: its matrix is too ill-conditioned";
  }
}

/// Takes a step for which the solver's memory counts and that reads no node maps: several ranks, each of which has all
/// of them, put them aside meanwhile.
template <class Step>
void withoutNodes(Model& model, const Comm& comm, const Step& step)
{
  if (comm.size() == 1 || !model.solvesWhole || model.told)
    return step();
  std::vector<int> orders;
  for (BodyModel& body : model.bodies)
    orders.push_back(std::exchange(body.nodes, {}).order);
  const auto restore = [&] {
    for (std::size_t b = 0; b < orders.size(); ++b)
      model.bodies[b].nodes = makeNodeMap(model.bodies[b].mesh, orders[b]);
  };
  try {
    step();
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

/// Couples the bodies; keeps the last state or, when asked, the state of every sweep.
void couple(Solved& solved, Model& model, const CondensedModel& condensed, const RunTools& tools, RunObserver& observer,
            const CouplingStart& start)
{
  const bool keepAll = tools.settings.output.steps == StepsWritten::AllSweeps;
  observer.sweeps(model);
  {
    const auto timer = timeStage(tools.ledger, Stage::Couple);
    const auto observe = [&](const SweepRecord& record, const InterfaceState& state) {
      observer.sweep(record);
      if (keepAll)
        solved.states.push_back(state);
    };
    withoutNodes(model, tools.comm,
                 [&] { solved.coupling = tools.coupling->solve(condensed.interface, observe, tools.ledger, start); });
    if (!keepAll)
      solved.states = {solved.coupling.state};
  }
  observer.stopped(solved.coupling);
}

/// Displacements and contact of what was coupled.
void recover(Solved& solved, const Model& model, const CondensedModel& condensed, const RunTools& tools)
{
  solved.fields = recoverFields(model, condensed, solved.states, tools.comm, tools.ledger);
  solved.contact = contactNodes(model, condensed, solved.coupling.state, solved.fields, solved.states.size() - 1);
  solved.doubt = undecidedContact(model, condensed, solved.coupling.state, solved.fields, tools.comm);
  if (!solved.doubt.empty()) {
    solved.coupling.converged = false;
    solved.coupling.reason = solved.doubt;
  }
}

/// Leaves no solution; the reason stands in the coupling's result.
void giveUp(Solved& solved, const std::string& reason, RunObserver& observer)
{
  solved.states.clear();
  solved.fields.clear();
  solved.contact.clear();
  solved.doubt.clear();
  solved.coupling.converged = false;
  solved.coupling.reason = reason;
  observer.gaveUp(reason);
}

/// Refuses recoveries that are not defined for bodies of this dimension and order, or that cannot change tractions.
void checkRecovery(const Model& model, const RunTools& tools, Diagnostics& diagnostics)
{
  const auto& errors = tools.settings.errors;
  if (!errors || !errors->recoversStress())
    return;
  const auto& nodes = model.bodies.front().nodes;
  const Params& list = errors->recoveryList;
  const auto recovery = tools.components.recoveries.build(list);
  if (const auto reason = recovery->refusal(nodes.dim, nodes.order, errors->optimises(*recovery, nodes.dim));
      !reason.empty())
    diagnostics.add(list.mistake("", reason + "."));
  if (errors->touches && errors->mode == ErrorMode::Paper && nodes.dim == 3 && nodes.order == 2)
    diagnostics.add(errors->place.mistake(
        "Mode", "Paper needs signs at the nodes, and in 3D second-order vertices carry no traction; use Strict."));
}

} // namespace

RunTools::RunTools(const RunSettings& givenSettings, const CertificateComponents& givenComponents,
                   const Comm& givenComm, Ledger& givenLedger)
    : settings(givenSettings), components(givenComponents), comm(givenComm), ledger(givenLedger),
      coupling(components.couplings.build(settings.couplingList)),
      solver(components.linearSolvers.build(settings.scene.linearSolver)), errors(settings.errors)
{}

void checkModel(Model& model, const RunTools& tools, const Comm& having)
{
  const SceneSettings& scene = tools.settings.scene;
  Diagnostics diagnostics;
  const auto timer = timeStage(tools.ledger, Stage::Check);
  checkNumberRange(model, scene, diagnostics);
  diagnostics.throwIfAny(); // sums of such numbers mean nothing
  if (tools.coupling->roles() == Roles::Automatic)
    giveOneRole(model, scene, tools.coupling->needsRoles(), diagnostics);
  if (tools.coupling->needsRoles())
    refuseObstacles(model, scene, diagnostics);
  checkHeld(model, scene, diagnostics);
  if (tools.settings.output.exodus)
    checkFieldNames(model, scene, diagnostics);
  checkMemory(model, tools.settings, *tools.solver, tools.comm.size(), having, diagnostics);
  checkRecovery(model, tools, diagnostics);
  checkWantedNumbers(model, tools.settings, *tools.solver, diagnostics);
  if (tools.settings.strictInput)
    refuseWarnings(model, tools.settings, diagnostics);
  diagnostics.throwIfAny();
}

void readModel(Model& model, const RunTools& tools, const MeshOfBody& meshes)
{
  const SceneSettings& scene = tools.settings.scene;
  SceneToShare toShare = meshes ? SceneToShare() : sceneToShare(model, tools);
  if (toShare.told)
    return takeShares(model, std::move(toShare), {}, tools);
  if (meshes)
    remeshModel(model, scene, tools.components, meshes, tools.comm, tools.ledger);
  else
    updateModel(model, scene, tools.components, tools.comm, tools.ledger, meshesOf(std::move(toShare.drawn), scene));
  offerWhole(model, *tools.coupling, scene.interfaceOperator);
  checkModel(model, tools, tools.comm);
}

CondensedModel condense(const Model& model, CondensedModel&& previous, const RunTools& tools, RunObserver& observer)
{
  {
    const auto timer = timeStage(tools.ledger, Stage::Check);
    refusePulledOff(model);
  }
  const auto representation = tools.components.interfaceOperators.build(tools.settings.scene.interfaceOperator);
  return condense(model, *tools.solver, *representation, tools.comm, tools.ledger, std::move(previous),
                  [&](const std::string& body, const std::string& description) { observer.factor(body, description); });
}

void condenseRun(Run& run, const RunTools& tools, RunObserver& observer)
{
  run.condensed = condense(run.model, std::move(run.condensed), tools, observer);
}

FoundRoles findRoles(Model& model, CondensedModel& condensed, const std::vector<RoleSummary>& before,
                     const RunTools& tools)
{
  const bool chooses = tools.coupling->roles() == Roles::Automatic;
  if (!(chooses || tools.coupling->needsSpectrum()) || !tools.coupling->sweeps(condensed.interface))
    return {};
  std::vector<ConnectedBodies> parts;
  {
    const auto timer = timeStage(tools.ledger, Stage::Interface);
    parts = roleSpectra(condensed.interface, tools.ledger);
  }
  if (!chooses)
    return {joinedSpectrum(parts), {}};
  ChosenRoles chosen = chooseRoles(model, condensed, parts, tools.coupling->givenTheta(), before);
  return {chosen.spectrum, std::move(chosen.parts)};
}

void findRoles(Run& run, const RunTools& tools, RunObserver& observer)
{
  if (tools.coupling->needsRoles())
    refuseSharedNodes(run.model, run.condensed.interface, ListPlace(tools.settings.couplingList));
  run.spectrum.reset();
  if (!run.plan.runs(Stage::Couple))
    return;
  FoundRoles found = findRoles(run.model, run.condensed, run.summary.coupling->roles, tools);
  run.spectrum = found.spectrum;
  if (found.parts.empty())
    return;
  run.summary.coupling->roles = std::move(found.parts);
  nameSides(run.summary, run.model);
  observer.roles(run.summary.coupling->roles);
}

Solved solve(Model& model, CondensedModel& condensed, const RunTools& tools, RunObserver& observer,
             const CouplingStart& start)
{
  assembleAgain(condensed, model, tools.ledger);
  Solved solved;
  solved.failure = failureOf([&] {
    if (tools.settings.outline.interfaces > 0)
      couple(solved, model, condensed, tools, observer, start);
    else
      solved.states.emplace_back();
    recover(solved, model, condensed, tools);
  });
  return solved;
}

void solveRun(Run& run, const RunTools& tools, RunObserver& observer, CouplingStart start)
{
  start.spectrum = run.spectrum;
  run.certificate.reset(); // of another state
  run.solved = solve(run.model, run.condensed, tools, observer, start);
  if (!run.solved.failure.empty())
    throw NotConverged(run.solved.failure);
  if (!run.solved.doubt.empty())
    run.failure = "not converged: " + run.solved.doubt;
}

Certified certify(const Model& model, CondensedModel& condensed, const Solved& solved,
                  std::shared_ptr<const ReferenceSolution> reference, const RunTools& tools)
{
  Certified certified{{}, std::move(reference), {}};
  assembleAgain(condensed, model, tools.ledger);
  certified.failure = failureOf([&] {
    certified.certificate =
        certify(tools.settings.scene, *tools.errors, tools.components, model, condensed, solved.coupling, solved.fields,
                tools.comm, tools.ledger, certified.reference, [&] { giveBackStiffness(condensed); });
  });
  return certified;
}

void certifyRun(Run& run, const RunTools& tools)
{
  Certified certified = certify(run.model, run.condensed, run.solved, std::move(run.reference), tools);
  run.reference = std::move(certified.reference);
  if (certified.failure.empty())
    run.certificate = std::move(certified.certificate);
  else
    run.failure = "no certificate: " + certified.failure;
  if (!run.certificate)
    return;
  if (tools.settings.output.equilibratedStress || tools.settings.output.meanStress)
    run.certificate->gatherStress(tools.comm);
  else
    run.certificate->forgetStress();
  EnergyRecord& record = run.energies.of(SceneIdentity(tools.settings.scene, run.model));
  if (!run.contradiction)
    run.contradiction = compareEnergies(record, *run.certificate, run.energies.name(run.level));
  run.energy = record;
  if (run.contradiction)
    withdraw(*run.certificate, *run.contradiction);
}

void attempt(Run& run, RunObserver& observer, const std::function<void()>& steps)
{
  if (const auto failure = failureOf(steps); !failure.empty()) {
    run.certificate.reset();
    giveUp(run.solved, failure, observer);
  }
}

void finishRun(Run& run, const RunTools& tools)
{
  run.strictInput = tools.settings.strictInput;
  run.summary = completeSummary(run, tools.settings, tools.comm);
  if (const std::string verdict = verdictOn(run.summary, run.solved, tools.settings); !verdict.empty())
    run.failure = verdict;
  if (run.contradiction)
    run.failure = contradictionText(*run.contradiction);
  copyLedger(run.summary, tools.ledger, run.startSeconds);
}

} // namespace ndframe
