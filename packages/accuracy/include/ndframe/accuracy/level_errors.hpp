#pragma once

#include "ndframe/accuracy/checkpoint.hpp"
#include "ndframe/run/accuracy_options.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// LevelNumbers and what follows from them.
struct LevelErrors : LevelNumbers
{
  LevelErrors(const Run& run, const AccuracyOptions& options); ///< of its certificate, which has the global measure
  explicit LevelErrors(const LevelNumbers& numbers) : LevelNumbers(numbers) {} ///< as they were recorded

  bool reached() const { return bound <= target; } ///< guaranteed or not
  /// Whether anything can be predicted from the bound: one above the solution's own size says only that.
  bool tells() const { return relative <= 1.0; }

  /// Whether the bound may be one of the sweeps although their own measure is small: tractions that are left where
  /// contact opens cost the bound traction times opening, which the energy of the iteration hardly sees. before: the
  /// levels.
  bool mayBeOfSweeps(const std::vector<LevelSummary>& before) const;

  /// The part of the sweeps with which this mesh would reach the target; infinite when it cannot.
  double iterationToTarget() const;
};

/// The line of a level without what it predicts. meshes: per elastic body, as they were refined, whole. Collective.
LevelSummary summarizeLevel(const Run& run, const std::vector<const Mesh*>& meshes, const LevelLesson& lesson,
                            const Comm& comm);

} // namespace ndframe
