#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Mean stress of every cell, sigma_h = K eps(u_h), as (xx, yy, zz, xy, yz, xz).
/// displacement: numNodes * dim, global axes. For order 2 the mean equals the value at the centroid.
std::vector<std::array<double, 6>> cellStress(const BodyModel& body, const Vector& displacement);

/// int_E K eps(v) : eps(v) of every cell. displacement: v, numNodes * dim, global axes.
Vector cellEnergies(const BodyModel& body, const Vector& displacement);

/// a(u, u) = int K eps(u) : eps(u) (no 1/2) = u . K u, u in the nodes' own axes.
double energy(const BodySystem& system, const Vector& u, const Comm& comm);

} // namespace ndframe
