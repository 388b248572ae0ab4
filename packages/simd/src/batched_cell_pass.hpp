#pragma once

#include "batched_kernels.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// K eps(u) at the vertices of all cells of a plane body: per cell, local vertex: xx, yy, xy.
Vector vertexStress(const BodyModel& body, const BatchedKernels& kernels, const Vector& displacement);

/// cellDistances for plane bodies, several cells at a time.
Vector batchedCellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference,
                            const BatchedKernels& kernels);

} // namespace ndframe
