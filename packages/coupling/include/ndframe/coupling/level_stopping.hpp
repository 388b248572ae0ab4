#pragma once

#include "ndframe/base/registry.hpp"

namespace ndframe
{

/// When the sweeps on one of several meshes have come far enough.
class LevelStopping
{
public:
  virtual ~LevelStopping() = default;

  /// The part of the error (energy norm) that the iteration may leave on a mesh whose own part is `mesh`.
  /// share: Iteration Share. 0: the coupling's own Stopping decides.
  virtual double allowed(double mesh, double share) const = 0;
};

/// "Balanced" (default), "Tolerance".
void registerLevelStoppings(Registry<LevelStopping>& registry);

} // namespace ndframe
