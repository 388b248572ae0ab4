#pragma once

#include "ndframe/condensation/solver_components.hpp"
#include "ndframe/recovery/stress_recovery.hpp"
#include "ndframe/scene/scene_components.hpp"

namespace ndframe
{

/// All that a run on given meshes needs.
struct CertificateComponents : SceneComponents, SolverComponents
{
  Registry<StressRecovery> recoveries{"recovery", "Automatic"}; ///< how equilibrated stresses are found
};

} // namespace ndframe
