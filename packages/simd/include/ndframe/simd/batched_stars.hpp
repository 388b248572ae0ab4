#pragma once

#include <memory>

#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

struct BatchedKernels;
struct BatchedStarData;

/// The star problems of two-dimensional bodies, several at a time: one star per SIMD lane, stars of equal valence
/// together.
///
/// The same minimisation as the general star solver's, organised for speed (docs/theory.md, "Stars in batches"). Closed
/// stars and fans with any supports, loads and contact at their two ends are solved here. What is left to the general
/// solver: vertices where the body touches itself, and everything in 3-D.
///
/// Connectivity is found once, in the constructor; `body` and `data` must outlive the object.
class BatchedStars
{
public:
  /// The fastest kernels that the machine has.
  BatchedStars(const BodyModel& body, const StaticData& data);
  /// Kernels of a chosen instruction set: all give the same to round-off.
  BatchedStars(const BodyModel& body, const StaticData& data, const BatchedKernels& kernels);
  ~BatchedStars();
  BatchedStars(BatchedStars&&) noexcept; ///< leaves the other one without tables: it solves no star

  /// Initial pass: adds c_a of these vertices to the corrections (one per field; sized and zeroed by the caller) and
  /// raises their defect. Returns the vertices left to the general solver, of which nothing was added.
  std::vector<int> add(const std::vector<FieldInput>& fields, const std::vector<int>& vertices,
                       std::vector<StressCorrection>& corrections) const;

  /// A block of a sweep: changes the corrections in the stars of these vertices by the field without data that makes
  /// the energy of the total smallest. No two of the vertices may be neighbours. Returns the vertices left.
  std::vector<int> relax(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections) const;

private:
  std::unique_ptr<const BatchedStarData> data_;
};

} // namespace ndframe
