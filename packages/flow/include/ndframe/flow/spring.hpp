#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{

/// Force and moment.
using ForceMoment = std::array<double, 6>;

/// What passes between two bodies that move against each other by x -> a + b x (x - centre):
///
///   F = conductance a,   M = turning b   about the centre.
struct Spring
{
  Direction centre{};
  double conductance = 0.0;
  std::array<double, 6> turning{}; ///< symmetric: xx, yy, zz, xy, xz, yz

  /// Of a flat piece of this conductance and size.
  static Spring ofFace(const Direction& centre, double conductance, double size);
  /// Springs side by side are one.
  static Spring joined(const std::vector<Spring>& parts);
  /// The part's share of a wrench on this whole, both about their own centres.
  ForceMoment shareOf(const Spring& part, const ForceMoment& wrench) const;
};

/// moment += factor arm x force
void addCross(const Direction& arm, const double* force, double factor, double* moment);

/// sum += a wrench about one point as one about another.
void addMoved(const ForceMoment& wrench, const Direction& from, const Direction& to, ForceMoment& sum);

} // namespace ndframe
