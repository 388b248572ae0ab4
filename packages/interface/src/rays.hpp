#pragma once

#include <optional>

#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

Direction difference(const Direction& a, const Direction& b);
double cross(const Direction& a, const Direction& b);

/// n on an edge at a place from 0 to 1.
Direction normalAt(const SideEdge& edge, double s);
/// The edge's own outward unit normal.
Direction ownNormal(const SideEdge& edge);

/// The place s on an edge whose ray runs through y: (y - x(s)) x n(s) = 0, if there is one change of sign between.
std::optional<double> rayThrough(const SideEdge& edge, const Direction& y);

/// Where the ray from x along n meets an edge: place on it, and how far away.
struct Hit
{
  double place, distance;
};

std::optional<Hit> meet(const Direction& x, const Direction& n, const SideEdge& edge);

} // namespace ndframe
