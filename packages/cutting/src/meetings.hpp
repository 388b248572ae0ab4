#pragma once

#include <set>

#include "flat_overlay.hpp"
#include "flat_pairs.hpp"

namespace ndframe
{

/// Points are one within this part of the edges around them.
constexpr double samePoint = 1e-3;

/// A vertex of either side that lies on the other, or where edges of both cross.
struct Meeting
{
  Vector3 x{};
  std::array<Carrier, 2> on;         ///< on either side
  std::array<int, 2> number{-1, -1}; ///< in the meshes; -1: on none
  bool isMoved = false;              ///< by smooth()
};

/// Where two sides that lie on each other meet.
struct Meetings
{
  bool ofRims = false;                   ///< OverlayManner::ofRims
  std::vector<std::array<int, 2>> pairs; ///< flatPairs()
  std::array<std::set<int>, 2> used;     ///< facets of pairs
  std::array<std::set<std::array<int, 2>>, 2> creases;
  std::vector<Meeting> points;
  std::array<std::map<int, int>, 2> atVertex;            ///< per vertex of a facet that is used, the point
  std::array<std::map<int, std::vector<int>>, 2> chains; ///< per edge the points between its ends, in order

  /// Facets that lie on each other, directly or by others, by side: each such set is triangulated as one.
  std::vector<std::array<std::vector<int>, 2>> patches() const;
  /// Of the second side only the rims may count.
  bool edgeCounts(std::size_t s, const SideTopology& side, int edge) const
  {
    return s == 0 || !ofRims || creases[s].count(side.ends(edge)) > 0;
  }
  /// The points along an edge of a side, with its ends.
  std::vector<int> wholeChain(std::size_t s, const SideTopology& side, int edge) const;
};

/// Finds vertices that are one, on edges (which are led through them: OverlayManner::near) and in facets, and where
/// edges cross.
Meetings findMeetings(const SideTopology& first, const SideTopology& second, const OverlayManner& manner);

} // namespace ndframe
