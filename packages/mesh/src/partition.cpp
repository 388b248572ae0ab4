#include "ndframe/mesh/partition.hpp"

#include <new>

#include <fmt/format.h>
#include <metis.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

std::vector<int> partitionNodes(const std::vector<int>& cellNodes, int nodesPerCell, int numNodes, int parts,
                                const std::vector<int>& weights)
{
  NDFRAME_ASSERT(parts >= 1 && nodesPerCell >= 1 && cellNodes.size() % std::size_t(nodesPerCell) == 0,
                 "a partition needs whole cells and at least one part");
  NDFRAME_ASSERT(weights.empty() || int(weights.size()) == numNodes, "one weight per node is needed");
  std::vector<int> owner(numNodes, 0);
  if (parts == 1 || numNodes == 0)
    return owner;

  static_assert(sizeof(idx_t) == sizeof(int), "METIS is built with 32-bit indices");
  idx_t numCells = idx_t(cellNodes.size()) / nodesPerCell;
  std::vector<idx_t> offsets(numCells + 1);
  for (idx_t c = 0; c <= numCells; ++c)
    offsets[c] = c * nodesPerCell;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 0;
  options[METIS_OPTION_NUMBERING] = 0;

  idx_t nodes = numNodes;
  idx_t numParts = parts;
  idx_t cut = 0;
  std::vector<idx_t> cellOwner(numCells);
  // METIS takes connectivity and weights by non-const pointers but does not change them with C numbering.
  const int status = METIS_PartMeshNodal(&numCells, &nodes, offsets.data(), const_cast<idx_t*>(cellNodes.data()),
                                         weights.empty() ? nullptr : const_cast<idx_t*>(weights.data()), nullptr,
                                         &numParts, nullptr, options, &cut, cellOwner.data(), owner.data());
  if (status == METIS_ERROR_MEMORY)
    throw std::bad_alloc();
  NDFRAME_ASSERT(status == METIS_OK, fmt::format("METIS_PartMeshNodal returned {}", status));
  return owner;
}

} // namespace ndframe
