#pragma once

#include "flat_pairs.hpp"

namespace ndframe
{

/// What a point of a triangulation may do.
struct Freedom
{
  enum class Kind
  {
    Fixed,
    OnLine,
    InPlane
  };
  Kind kind = Kind::InPlane;
  Flat way{};             ///< of the line, any length
  double most = HUGE_VAL; ///< it moves no further than this
};

/// Moves points of a triangulation (counterclockwise) so that its flat triangles become rounder: each in turn to the
/// best of some places near it, where the worst triangle around it (triangleShape) gains. Triangles that do not count
/// only have to stay turned as they are.
void smoothTriangles(std::vector<Flat>& points, const std::vector<Freedom>& freedoms,
                     const std::vector<std::array<int, 3>>& triangles, const std::vector<char>& counts);

} // namespace ndframe
