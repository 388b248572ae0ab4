#pragma once

#include "ndframe/run/accuracy_options.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What the certificate of a mesh says to a run with a target; absolute, in the energy norm.
struct LevelErrors
{
  LevelErrors(const Run& run, const AccuracyOptions& options);

  double bound = 0.0;     ///< what is compared with the target
  double target = 0.0;    ///< of the bound
  double relative = 0.0;  ///< the bound over the norm of the solution
  double iteration = 0.0; ///< the part of the stopped sweeps
  double mesh = 0.0;      ///< the rest of the bound of the displacement's error
  double contact = 0.0;   ///< in the bound: tractions across openings, of the mesh or left by the sweeps

  bool reached() const { return bound <= target; }
  /// Whether anything can be predicted from the bound: one above the solution's own size says only that.
  bool tells() const { return relative <= 1.0; }

  /// Whether the bound may be one of the sweeps although their own measure is small: tractions that are left where
  /// contact opens cost the bound traction times opening, which the energy of the iteration hardly sees. before: the
  /// levels.
  bool mayBeOfSweeps(const std::vector<LevelSummary>& before) const;

  /// The part of the sweeps with which this mesh would reach the target; infinite when it cannot.
  double iterationToTarget() const;
};

/// The line of a level without what it predicts.
LevelSummary summarizeLevel(const Run& run, const LevelErrors& errors);

} // namespace ndframe
