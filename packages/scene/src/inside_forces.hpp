#pragma once

#include "ndframe/scene/drawn_pieces.hpp"

namespace ndframe
{

/// What the loads of a body on all its cells do but those that rank 0 has as its outer ones. None where a rank cannot
/// say it: a value is not finite, or the loads have mistakes. Collective.
std::optional<ForcesInside> forcesInside(const BodyPieces& body, const BodySettings& settings,
                                         const SceneComponents& components, int order, const Comm& comm);

} // namespace ndframe
