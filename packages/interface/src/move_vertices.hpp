#pragma once

#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

/// Moves vertices of straight sides that lie on each other to a vertex of the other side within 5 % of their facets:
/// those of the second side, or, where one must stay, those of the first. Corners of a side, ends of named sides and
/// whatever would spoil a cell stay. Returns whether any moved.
bool moveVertices(const SideMap& map, Mesh& first, const std::string& firstSide, Mesh& second,
                  const std::string& secondSide, const std::vector<FacingPiece>& pieces);

} // namespace ndframe
