#include "ndframe/simd/cell_distances.hpp"

#include "batched_cell_pass.hpp"
#include "batched_workspace.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"

namespace ndframe
{

Vector cellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference)
{
  if (body.mesh.dim == 2)
    return batchedCellDistances(body, correction, difference, *availableKernels().back());
  Vector distances;
  visitStresses(body, difference, correction,
                [&](int cell, const SplitStress& stress) { distances.push_back(stress.energy(body.laws(cell))); });
  return distances;
}

} // namespace ndframe
