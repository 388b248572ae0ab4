#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/condensation/reactions.hpp"

namespace ndframe
{

/// A largest value and where it is.
struct PeakSummary
{
  double value = 0.0;        ///< a length, or a strain (no unit)
  std::vector<double> point; ///< the node or vertex where it is, undeformed; of equal values the first
};

/// A part of a body with a material of its own.
struct RegionSummary
{
  std::string name;          ///< empty: what is in no region that the deck names
  std::int64_t elements = 0; ///< cells
  double energy = 0.0;       ///< its part of a(u,u)
};

/// One body in NAME.summary.json.
struct BodySummary
{
  std::string name;                     ///< of its list in the deck; bodies that are tied are one, "A + B"
  std::int64_t dofs = 0;                ///< dim * nodes, supports included
  std::int64_t elements = 0;            ///< cells of its mesh
  int order = 0;                        ///< polynomial degree of the displacement, 1 or 2
  std::string solver;                   ///< linear solver that factors it; "-": it is rigid
  std::string heldBy;                   ///< "x: roller at left; y: contact only"
  double energy = 0.0;                  ///< a(u,u) = int K eps:eps, no 1/2
  std::vector<double> loadForce;        ///< resultant of its loads
  std::vector<SupportSummary> supports; ///< in deck order; without a solution their vectors are empty
  PeakSummary displacement;             ///< |u|
  PeakSummary strain;                   ///< absolute principal strain, in the plane in plane scenes
  double strainedShare = 0.0;           ///< of its measure, in cells with strains above `Strain Limit`
  std::vector<RegionSummary> regions{}; ///< none: the body is one part
};

} // namespace ndframe
