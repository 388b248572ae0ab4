#pragma once

#include "ndframe/assembly/constraint_set.hpp"

namespace ndframe
{

/// Moment of a force at an arm: about z in the plane (one entry), about x, y, z in space.
std::vector<double> momentOf(const Direction& arm, const Direction& force, int dim);

} // namespace ndframe
