#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Where a body really is before loading. The meshes of two sides touch although a Gap g stands between the bodies; so
/// that a picture shows no penetration the Dirichlet body is drawn moved by -g n_c at its nodes of the interface, its
/// Neumann side and other bodies' stay; of a rigid Neumann body it is the surface that is moved, by g n_c. Inside a
/// body the offset is that of the nearest node of its sides, a mean of several sides weighted with the squared inverse
/// distance; it is for pictures and enters no result. Global axes, numNodes * dim; empty when no interface of the scene
/// has a gap.
std::vector<NodalField> gapOffsets(const Model& model);

} // namespace ndframe
