#pragma once

#include <optional>

#include "ndframe/drawing/drawn_scene.hpp"

namespace ndframe
{

/// How far the first of two plane bodies moves along a direction (of length 1) until its side meets that of the second:
/// the least t with p + t d on the other side, p a vertex of either side, of facets that look at each other. Nothing
/// where they pass each other by, and for solids, whose sides touch as they are drawn. Costs facets times facets.
std::optional<double> travelUntilContact(const DrawnAssembly& scene, const DrawnContact& contact, std::size_t moved,
                                         const Vector3& direction);

} // namespace ndframe
