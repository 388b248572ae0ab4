#pragma once

#include <limits>
#include <optional>

#include "carried_solution.hpp"
#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/run/failure.hpp"

namespace ndframe
{

/// The level with the smallest bound so far, of those with a guarantee if there are any.
struct BestLevel
{
  int level = 0; ///< from 1; 0: none
  std::vector<Mesh> meshes;
  CarriedContact contact; ///< with the Neumann traction
  std::vector<RoleSummary> roles;
};

/// The loop of a run with a target: solve until the iteration is small beside the mesh, certify, stop or refine, carry
/// over.
class AdaptiveRun
{
public:
  AdaptiveRun(RunTools tools, const AccuracyComponents& components, RunObserver& observer, const LevelObserver& onLevel,
              EnergyRecords energies, const Restart& restart);

  Run run(Model known);

private:
  // The loop.
  void begin(Model model);
  /// Records the level that was solved. False without an answer on it, at the target, and at the end of progress.
  bool needsAnother();
  /// Goes to the next meshes and solves. Whatever fails on the way is a limit, as the levels before have an answer.
  bool takeNext();
  bool solveNext();
  void endWith(const Failure& failure);
  void readLevel(const std::vector<Mesh>& meshes, const std::vector<InterfaceMesh>& before);
  void beginLevel(Model&& model, const std::vector<InterfaceMesh>& before);
  Progress progress() const;
  void solveLevel();
  /// Solves from there and certifies. before: sweeps on this mesh, which those of the solve are added to.
  void solveFrom(CouplingStart start, SweepsRecord& before);
  CouplingStart firstStart() const;
  /// Whether there is a solution that iterations on the next meshes may begin with, whatever solved this level.
  bool carriesSolution() const;
  /// What the iteration has reached, to go on from.
  CouplingStart presentState() const;
  double allowedIteration(double mesh) const { return stopping_->allowed(mesh, options_.iterationShare); }
  void record(const LevelErrors& errors, LevelLesson&& lesson);
  /// The level as the user is told of it, and the best one if it is. contact: with the Neumann traction.
  void enter(const LevelSummary& level, const CarriedContact& contact);
  /// What there is to say of its meshes, and that ranks have shares of them for the first time.
  std::string noteOfLevel();
  /// Plans the next meshes; AccuracySummary::limit says when they do not fit into the limits.
  void refine();
  void carryOver(MeshPlan plan);
  std::vector<const Mesh*> uncutMeshes() const; ///< of this level, whole, per elastic body
  double largestOf(double value) const;         ///< of all ranks, on each: they go on alike
  void returnToBest();
  void solveBestAgain();
  Run finish();

  // The way back into it (restart.cpp).
  LevelRecord recordOf(const LevelSummary& level, LevelLesson&& lesson, const CarriedContact& contact) const;
  Checkpoint checkpoint() const;
  /// With the solution of the level that run_ is of.
  Checkpoint levelCheckpoint() const;
  void keepCheckpoint() const;
  /// Goes through the levels of a checkpoint without solving them, and solves the next one; false when there is none.
  bool resume(const Checkpoint& checkpoint);
  void restore(const LevelRecord& level);
  void recall(const EnergyEnds& energy);
  /// The sweeps that a checkpoint has of the present level, if it has some: the start then goes on from them.
  SweepsRecord takeSweeps(CouplingStart& start);
  void keepSweeps(const SweepsRecord& before, const SweepsDone& done, const CouplingStart& start) const;

  const AccuracyComponents& components_;
  RunObserver& observer_;
  RunObserver silent_; ///< of the levels after the first
  const LevelObserver& onLevel_;
  const Restart& restart_;
  RunTools tools_;
  const AccuracyOptions options_;
  const std::vector<Estimator> wanted_; ///< by the deck
  Run run_;
  const std::unique_ptr<ContactTransfer> transfer_;
  const std::unique_ptr<LevelStopping> stopping_;
  const bool balances_; ///< the sweeps on a mesh end by their part of the error, not by Coupling/Stopping
  std::optional<MeshPlanner> planner_;
  double expectedMesh_ = std::numeric_limits<double>::max(); ///< the mesh's part on the next level; unknown at first
  std::optional<LevelErrors> errors_;                        ///< of the last level that was recorded
  CarriedContact next_;                                      ///< what the level after it begins with
  CarriedContact carried_;                                   ///< what the present level begins with
  CarriedSolution solution_;                                 ///< of the level before
  bool expectsTarget_ = false;                               ///< the meshes were made to reach the target
  bool isLoose_ = false; ///< the solution of this level is as exact as the next meshes need it
  BestLevel best_;
  bool saysShares_ = true;                  ///< nothing has told yet that ranks have shares of levels
  int sweeps_ = 0;                          ///< of this level
  std::int64_t firstMemory_ = peakMemory(); ///< bytes, before there was a mesh
  std::int64_t earlierMemory_ = 0;          ///< the most that an earlier process took
  AccuracySummary summary_;
  std::vector<LevelRecord> done_;          ///< for a checkpoint, if there is one
  std::optional<SweepsRecord> sweepsDone_; ///< of a checkpoint, until they are taken
  SharedPasses shared_;                    ///< belongs to them, or to the passes of this level
};

} // namespace ndframe
