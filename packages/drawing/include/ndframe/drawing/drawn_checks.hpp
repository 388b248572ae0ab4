#pragma once

#include <optional>

#include "ndframe/drawing/drawn_scene.hpp"

namespace ndframe
{

/// Throws InputError where no body has a named side: how sides get names.
void refuseNamelessSides(const DrawnAssembly& scene);

/// Throws InputError for a body of parts that nothing connects, which would need a support each: places on two of them,
/// and how they become bodies.
void refuseUnconnectedParts(const DrawnAssembly& scene);

/// Throws InputError for a name of a body that a list of names cannot hold: with a comma or a brace.
void refuseNamesOfLists(const std::vector<std::string>& bodies);

/// Two plane bodies of which one has a cell's centre inside the other.
struct DrawnOverlap
{
  /// Name of the body in which the place lies.
  std::string first, second; ///< name of the body whose cell it is
  Vector3 place;             ///< centre of the cell
};

/// The first overlap of plane bodies, if there is one.
std::optional<DrawnOverlap> overlapOf(const DrawnAssembly& scene);

} // namespace ndframe
