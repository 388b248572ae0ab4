#pragma once

#include <vector>

#include "batched_kernels.hpp"

namespace ndframe
{

/// Doubles aligned for every kernel.
class AlignedDoubles
{
public:
  AlignedDoubles() = default;
  explicit AlignedDoubles(std::size_t size) : blocks_((size + 7) / 8) {}
  double* data() { return blocks_.empty() ? nullptr : blocks_.front().values; }

private:
  struct alignas(64) Block
  {
    double values[8] = {};
  };
  std::vector<Block> blocks_;
};

/// Room for the largest batch of a pass; all numbers are zero at first.
class BatchWorkspace
{
public:
  /// total: numbers per cell and field of StarBatch::total, zero in the initial pass. severalLaws: with a compliance
  /// for every cell.
  BatchWorkspace(int degree, int lanes, int maxCells, int fields, const LoadModes& loads, int total, bool severalLaws);
  /// The arrays for a batch.
  StarBatch batch(int cells, bool closed) const;

private:
  AlignedDoubles memory_;
  StarBatch batch_;
};

/// The kernels that this machine can run, the fastest last.
std::vector<const BatchedKernels*> availableKernels();

} // namespace ndframe
