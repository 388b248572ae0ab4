#include "ndframe/simd/cell_distances.hpp"

#include <numeric>

#include "batched_cell_pass.hpp"
#include "batched_workspace.hpp"
#include "ndframe/equilibrium/solid_energies.hpp"

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
  return solidEnergies(body, difference, correction, cells);
}

} // namespace ndframe
