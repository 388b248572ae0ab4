#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ndframe
{

/// A solution at one point of a body.
struct PointSummary
{
  /// Coordinates, undeformed.
  std::vector<double> point, displacement; ///< dim each
  std::array<double, 6> stress{};          ///< (xx, yy, zz, xy, yz, xz)
  double vonMises = 0.0;                   ///< of this stress
  /// Force per area, never negative.
  std::optional<double> contactPressure, contactGap; ///< where the point lies on an interface
};

/// Integrals over a side of a body.
struct SideSummary
{
  std::string side;                 ///< its name
  double measure = 0.0;             ///< length or area
  std::vector<double> displacement; ///< mean
  std::vector<double> force;        ///< int sigma_h n dS
  std::vector<double> moment;       ///< about `about`: about z in the plane, about x, y, z in space
  std::vector<double> about;        ///< point of the deck, or the side's centroid
};

/// What one entry of Output/Probes found: a point, the points of a line, or a side.
struct ProbeSummary
{
  /// Of its list in Output/Probes.
  std::string name, body;           ///< as BodySummary::name
  bool isLine = false;              ///< points of a line, both ends included
  std::vector<PointSummary> points; ///< one unless it is a line; none of a side
  std::optional<SideSummary> side;  ///< absent for points and lines
};

} // namespace ndframe
