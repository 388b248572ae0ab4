#include "ndframe/simd/cell_distances.hpp"

#include <numeric>

#include "batched_cell_pass.hpp"
#include "batched_workspace.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"

namespace ndframe
{

Vector cellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference)
{
  if (body.mesh.dim == 2)
    return batchedCellDistances(body, correction, difference, *availableKernels().back());
  std::vector<int> all(std::size_t(body.mesh.numCells()));
  std::iota(all.begin(), all.end(), 0);
  return solidDistances(body, correction, difference, all);
}

Vector solidDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference,
                      const std::vector<int>& cells)
{
  Vector distances;
  visitStresses(body, difference, correction, cells,
                [&](int cell, const SplitStress& stress) { distances.push_back(stress.energy(body.laws(cell))); });
  return distances;
}

} // namespace ndframe
