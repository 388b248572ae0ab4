#include "ndframe/simd/batched_stars.hpp"

#include <algorithm>

#include "batched_pass.hpp"

namespace ndframe
{
namespace
{

/// Runs a pass over the vertices, batch by batch of one valence and kind, as soon as one is full: batches stay close to
/// the order of the vertices. Returns those that are not simple.
std::vector<int> runBatches(const BatchedStarData& stars, const StarFieldInputs* inputs,
                            const std::vector<int>& vertices, std::vector<StressCorrection>& corrections)
{
  const Rings& rings = stars.rings;
  std::vector<int> left;
  int maxCells = 0;
  for (const int vertex : vertices)
    maxCells = std::max(maxCells, rings.valence(vertex));
  BatchedPass pass(stars, inputs, maxCells, corrections);
  std::vector<std::vector<int>> waiting(2 * std::size_t(maxCells) + 2);
  for (const int vertex : vertices) {
    if (rings.kind(vertex) == Rings::Kind::None) {
      left.push_back(vertex);
      continue;
    }
    auto& batch =
        waiting[2 * std::size_t(rings.valence(vertex)) + std::size_t(rings.kind(vertex) == Rings::Kind::Fan ? 1 : 0)];
    batch.push_back(vertex);
    if (int(batch.size()) == stars.kernels.lanes) {
      pass.run(batch.data(), int(batch.size()));
      batch.clear();
    }
  }
  for (const auto& batch : waiting)
    if (!batch.empty())
      pass.run(batch.data(), int(batch.size()));
  return left;
}

} // namespace

BatchedStars::BatchedStars(const BodyModel& body, const StaticData& data)
    : BatchedStars(body, data, *availableKernels().back())
{}

BatchedStars::BatchedStars(const BodyModel& body, const StaticData& data, const BatchedKernels& kernels)
    : data_(data.dim == 2 ? std::make_unique<BatchedStarData>(body, data, kernels) : nullptr)
{}

BatchedStars::~BatchedStars() = default;
BatchedStars::BatchedStars(BatchedStars&&) noexcept = default;

std::vector<int> BatchedStars::add(const std::vector<FieldInput>& fields, const std::vector<int>& vertices,
                                   std::vector<StressCorrection>& corrections) const
{
  if (!data_)
    return vertices;
  const StarFieldInputs inputs(*data_, fields);
  return runBatches(*data_, &inputs, vertices, corrections);
}

std::vector<int> BatchedStars::relax(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections) const
{
  if (!data_)
    return vertices;
  return runBatches(*data_, nullptr, vertices, corrections);
}

} // namespace ndframe
