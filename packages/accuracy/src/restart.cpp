#include <fmt/format.h>

#include "accuracy_limits.hpp"
#include "level_loop.hpp"
#include "ndframe/base/byte_hash.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"
#include "ndframe/run/summarize.hpp"

namespace ndframe
{
namespace
{

std::string hashOf(const std::vector<Mesh>& meshes)
{
  std::uint64_t hash = byteHash(nullptr, 0);
  for (const Mesh& mesh : meshes) {
    const std::string bytes = toBytes(mesh);
    hash = byteHash(bytes.data(), bytes.size(), hash);
  }
  return fmt::format("{:016x}", hash);
}

/// A contact state on the model's interfaces; empty without them.
CarriedContact contactOn(const Model& model, const Vector& traction, const std::vector<int>& closed)
{
  if (model.interfaces.empty())
    return {};
  return {model.interfaces, atInterface(traction), {closed.begin(), closed.end()}};
}

/// Turns the interfaces as the roles that were chosen on them left them.
void orient(Model& model, const std::vector<int>& dirichletBodies)
{
  std::vector<InterfaceMesh> others(model.interfaces.size());
  for (std::size_t i = 0; i < others.size(); ++i)
    others[i].sides[0].body = dirichletBodies[i];
  orientLike(model, others);
}

std::vector<Ledger::Stage> stagesOf(const std::vector<StageRecord>& records)
{
  std::vector<Ledger::Stage> stages;
  for (const StageRecord& stage : records)
    stages.push_back({stage.name, stage.seconds, stage.peakBytes});
  return stages;
}

EnergyEnds energyEnds(const EnergyRecord& record)
{
  const auto &lower = record.lowerSide(), &upper = record.upperSide();
  return {{lower.value, lower.roundOff, lower.name}, {upper.value, upper.roundOff, upper.name}, record.certificates()};
}

/// The names of another scene's parts would not fit.
bool fits(const LevelRecord& level, const Model& model)
{
  std::size_t nodes = 0;
  for (const InterfaceMesh& interface : model.interfaces)
    nodes += std::size_t(interface.numNodes());
  return level.dirichletBodies.size() == model.interfaces.size() && level.closed.size() == nodes &&
         level.tractionNeumann.size() == nodes && level.nextTraction.size() == nodes;
}

} // namespace

LevelRecord AdaptiveRun::recordOf(const LevelSummary& level, LevelLesson&& lesson, const CarriedContact& contact) const
{
  LevelRecord record;
  record.summary = level;
  record.lesson = std::move(lesson);
  record.meshes = hashOf(planner_->meshes());
  record.nextTraction = next_.traction;
  record.tractionNeumann = contact.traction;
  record.closed.assign(contact.closed.begin(), contact.closed.end());
  for (const InterfaceMesh& interface : run_.model.interfaces)
    record.dirichletBodies.push_back(interface.dirichlet().body);
  record.roles = rolesOf(run_);
  record.energy = energyEnds(run_.energy);
  return record;
}

Checkpoint AdaptiveRun::checkpoint() const
{
  Checkpoint checkpoint;
  checkpoint.version = versionText();
  checkpoint.deckJson = toJson(tools_.settings.deck);
  checkpoint.levels = done_;
  checkpoint.seconds = wallSeconds() - run_.startSeconds;
  checkpoint.firstMemory = firstMemory_;
  checkpoint.peakMemory = std::max(earlierMemory_, peakMemory());
  checkpoint.counts = tools_.ledger.counts();
  for (const auto& stage : tools_.ledger.stages())
    checkpoint.stages.push_back({stage.name, stage.seconds, stage.peakBytes});
  return checkpoint;
}

Checkpoint AdaptiveRun::levelCheckpoint() const
{
  Checkpoint whole = checkpoint();
  if (carriesSolution())
    whole.solution = CarriedSolution(run_).values(tools_.comm);
  return whole;
}

void AdaptiveRun::keepCheckpoint() const
{
  if (restart_.keep && !done_.empty())
    restart_.keep(levelCheckpoint());
}

void AdaptiveRun::recall(const EnergyEnds& energy)
{
  const auto &lower = energy.lower, &upper = energy.upper;
  run_.energy = EnergyRecord({lower.value, lower.roundOff, lower.name}, {upper.value, upper.roundOff, upper.name},
                             energy.certificates);
  run_.energies.of(SceneIdentity(tools_.settings.scene, run_.model)) = run_.energy;
}

SweepsRecord AdaptiveRun::takeSweeps(CouplingStart& start)
{
  if (!sweepsDone_)
    return {};
  SweepsRecord taken = std::move(*sweepsDone_);
  sweepsDone_.reset();
  if (!arePassesOf(taken.done, shared_, run_.model))
    return {}; // other ranks have kept them: this level begins anew
  recall(taken.energy);
  start.iterationError = taken.goal;
  start.exactness = taken.isRough ? Exactness::Rough : Exactness::Full;
  start.sweeps.after = std::move(taken.done);
  return taken;
}

void AdaptiveRun::keepSweeps(const SweepsRecord& before, const SweepsDone& done, const CouplingStart& start) const
{
  Checkpoint kept = checkpoint();
  if (haveFields(done))
    kept.shared = shared_;
  kept.sweeps = before;
  kept.sweeps->done = done;
  kept.sweeps->goal = start.iterationError;
  kept.sweeps->isRough = start.exactness == Exactness::Rough;
  kept.sweeps->energy = energyEnds(run_.energy);
  restart_.write(kept);
}

bool AdaptiveRun::resume(const Checkpoint& checkpoint)
{
  run_.startSeconds -= checkpoint.seconds;
  firstMemory_ = checkpoint.firstMemory;
  earlierMemory_ = checkpoint.peakMemory;
  for (const LevelRecord& level : checkpoint.levels) {
    if (!summary_.levels.empty())
      readLevel(planner_->meshes(), run_.model.interfaces);
    restore(level);
  }
  if (restart_.write)
    done_ = checkpoint.levels;
  tools_.ledger.restore(checkpoint.counts, stagesOf(checkpoint.stages));
  sweepsDone_ = checkpoint.sweeps;
  shared_ = checkpoint.shared;
  if (!checkpoint.solution.empty())
    solution_ = CarriedSolution(run_.model, checkpoint.solution);
  if (checkpoint.levels.empty()) {
    attempt(run_, observer_, [&] { solveLevel(); });
    return true;
  }
  if (checkpoint.levels.back().maximumDofs > 0)
    return solveNext();
  summary_.limit = endOfProgress(options_, summary_.levels, {});
  if (summary_.limit.empty())
    return takeNext();
  keepCheckpoint();
  return false;
}

void AdaptiveRun::restore(const LevelRecord& level)
{
  if (level.meshes != hashOf(planner_->meshes()) || !fits(level, run_.model))
    throw InputError(
        fmt::format("\"{}\" belongs to other meshes: those of level {} are not the same; {}, or run without --restart.",
                    restart_.file, level.summary.level,
                    run_.level == 1 ? "use the original mesh files" : "use the program and the gmsh that made them"));
  orient(run_.model, level.dirichletBodies);
  if (run_.summary.coupling)
    run_.summary.coupling->roles = level.roles;
  recall(level.energy);
  planner_->learn(uncutMeshes(), level.lesson);
  enter(level.summary, contactOn(run_.model, level.tractionNeumann, level.closed));
  errors_ = LevelErrors(level.lesson.errors);
  next_ = contactOn(run_.model, level.nextTraction, level.closed);
  if (level.maximumDofs > 0)
    carryOver(planner_->nextStep(level.maximumDofs));
}

} // namespace ndframe
