#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/certification/energy_summary.hpp"

namespace ndframe
{

/// One mesh on the way to a target.
struct LevelSummary
{
  int level = 1; ///< from 1
  /// Of all elastic bodies, supports included.
  std::int64_t dofs = 0, elements = 0; ///< cells of all bodies
  double worstShape = 1.0;             ///< worstShape of its meshes; 1: all elements are equilateral
  int sweeps = 0;                      ///< on this mesh; 0 without interfaces
  double bound = 0.0;                  ///< what is compared with the target, absolute
  double relative = 0.0;               ///< over sqrt(a(u_h, u_h))
  double iteration = 0.0;              ///< of it: the stopped sweeps (energy norm)
  double mesh = 0.0;                   ///< of it: the rest, sqrt(bound^2 - iteration^2)
  std::string worstBody;               ///< where the largest contribution is
  std::vector<double> worstPoint;      ///< centre of that cell, dim coordinates
  std::int64_t dofsToTarget = 0;       ///< predicted for the target; 0 when it is reached
  double seconds = 0.0;                ///< since the run began
  std::optional<NumberBracket> energy; ///< of the exact solution, the best so far; absent without a guaranteed bound
  std::string doubt;                   ///< why the bound is not guaranteed; empty when it is
};

/// How a target was reached, or why not.
struct AccuracySummary
{
  std::string of;       ///< "Displacement", "Mean Stress"
  double target = 0.0;  ///< of the bound: a share, or absolute in the energy norm
  bool relative = true; ///< the target is over sqrt(a(u_h, u_h))
  bool reached = false; ///< the last bound is at most the target and guaranteed if one before is; none is contradicted
  std::string limit;    ///< why it was not; empty when it was
  std::vector<LevelSummary> levels; ///< in the order in which they were solved
  int written = 0;                  ///< the level whose answer is written, from 1: the last, or a better one before it

  /// The level that is written; needs written > 0.
  const LevelSummary& answer() const { return levels[std::size_t(written) - 1]; }
  int sweeps() const;             ///< of all levels
  std::int64_t totalDofs() const; ///< of all levels: the work
};

} // namespace ndframe
