#include "batched_workspace.hpp"

#include <utility>

namespace ndframe
{

BatchWorkspace::BatchWorkspace(int degree, int lanes, int maxCells, int fields, const LoadModes& loads, int total,
                               bool severalLaws)
{
  const int n = cellUnknowns(degree), facetData = 2 * (degree + 1), spokes = maxCells + 1;
  batch_.fields = fields;
  batch_.loads = &loads;
  const std::pair<double**, int> arrays[] = {{&batch_.spokes, 2 * spokes},
                                             {&batch_.stress, fields * maxCells * (total == 0 ? 9 : 0)},
                                             {&batch_.bodyLoad, maxCells * loads.modes * 2},
                                             {&batch_.total, fields * maxCells * total},
                                             {&batch_.compliance, severalLaws ? maxCells * 6 : 0},
                                             {&batch_.known, fields * maxCells * (n + 2 * loads.modes)},
                                             {&batch_.jumps, fields * spokes * facetData},
                                             {&batch_.offsets, fields * spokes * 3},
                                             {&batch_.panels, maxCells * panelSize(degree, fields)},
                                             {&batch_.scratch, fields * n},
                                             {&batch_.border, n * n},
                                             {&batch_.gradient, fields * n},
                                             {&batch_.solution, fields * n},
                                             {&batch_.tractions, fields * maxCells * 2 * facetData},
                                             {&batch_.divergence, fields * maxCells * 2},
                                             {&batch_.scale, fields}};
  std::size_t size = 0;
  for (const auto& [pointer, count] : arrays)
    size += std::size_t(count) * std::size_t(lanes);
  memory_ = AlignedDoubles(size);
  double* next = memory_.data();
  for (const auto& [pointer, count] : arrays) {
    *pointer = next;
    next += std::ptrdiff_t(count) * lanes;
  }
  if (!severalLaws)
    batch_.compliance = nullptr;
}

StarBatch BatchWorkspace::batch(int cells, bool closed) const
{
  StarBatch batch = batch_;
  batch.cells = cells;
  batch.closed = closed;
  return batch;
}

} // namespace ndframe
