#pragma once

#include <atomic>

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// Tells how many stars are in balance, then how many cells have their matrices, then how many steps are taken. Any
/// thread may say so.
class RecoveryProgress
{
public:
  RecoveryProgress(const RecoveryScene& scene, std::size_t descents, int steps, const Comm& comm, Ledger& ledger)
      : ledger_(ledger), steps_(std::int64_t(descents) * steps)
  {
    for (const BodyModel* body : scene.bodies)
      if (!body->isRigid) {
        stars_ += body->mesh.numPoints() / comm.size();
        cells_ += body->mesh.numCells() / comm.size(); // of this rank
      }
  }

  void starIsBalanced() { tell("star", ++balanced_, stars_); }
  void cellIsRead() { tell("cell", ++read_, cells_); }
  void stepIsTaken() { tell("step", ++taken_, steps_); }

private:
  void tell(const char* name, std::int64_t number, std::int64_t of)
  {
    ledger_.tell(Depth::Step, Progress::part(name, number, of, double(number) / double(of)));
  }

  Ledger& ledger_;
  std::int64_t stars_ = 0, cells_ = 0, steps_;
  std::atomic<std::int64_t> balanced_ = 0, read_ = 0, taken_ = 0;
};

} // namespace ndframe
