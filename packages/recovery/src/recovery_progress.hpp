#pragma once

#include <atomic>

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// Tells how many stars are in balance, then how many cells have their matrices, then how many steps are taken and what
/// they gain. Any thread may say so.
class RecoveryProgress
{
public:
  /// leastGain: at which a descent ends.
  RecoveryProgress(const RecoveryScene& scene, double leastGain, const Comm& comm, Ledger& ledger)
      : ledger_(ledger), leastGain_(leastGain)
  {
    for (const BodyModel* body : scene.bodies)
      if (!body->isRigid) {
        stars_ += body->mesh.numPoints() / comm.size();
        cells_ += body->mesh.numCells() / comm.size(); // of this rank
      }
  }

  void starIsBalanced() { tell("star", ++balanced_, stars_); }
  void cellIsRead() { tell("cell", ++read_, cells_); }
  void stepIsTaken(double gain)
  {
    ledger_.tell(Depth::Step, Progress::falling("step", ++taken_, "gain", gain, leastGain_));
  }

private:
  void tell(const char* name, std::int64_t number, std::int64_t of)
  {
    ledger_.tell(Depth::Step, Progress::part(name, number, of, double(number) / double(of)));
  }

  Ledger& ledger_;
  double leastGain_;
  std::int64_t stars_ = 0, cells_ = 0;
  std::atomic<std::int64_t> balanced_ = 0, read_ = 0, taken_ = 0;
};

} // namespace ndframe
