#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ndframe
{

/// What one support does to its body. In the plane forces are per unit thickness.
struct SupportSummary
{
  std::string name, description; ///< "ground", "clamp at bottom"
  std::vector<double> force;     ///< resultant
  std::vector<double> moment;    ///< about the centre of its side: about z in the plane, about x, y, z in space
  std::vector<double> centre;
};

/// A largest value and where it is.
struct PeakSummary
{
  double value = 0.0;
  std::vector<double> point;
};

/// A part of a body with a material of its own.
struct RegionSummary
{
  std::string name; ///< empty: what is in no region that the deck names
  std::int64_t elements = 0;
  double energy = 0.0; ///< its part of a(u,u)
};

/// One body in NAME.summary.json.
struct BodySummary
{
  std::string name;
  std::int64_t dofs = 0; ///< dim * nodes, supports included
  std::int64_t elements = 0;
  int order = 0;
  std::string solver;
  std::string heldBy;            ///< "x: roller at left; y: contact only"
  double energy = 0.0;           ///< a(u,u) = int K eps:eps, no 1/2
  std::vector<double> loadForce; ///< resultant of its loads
  std::vector<SupportSummary> supports;
  PeakSummary displacement;             ///< |u|
  PeakSummary strain;                   ///< absolute principal strain, in the plane in plane scenes
  std::vector<RegionSummary> regions{}; ///< none: the body is one part
};

} // namespace ndframe
