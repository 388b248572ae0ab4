#pragma once

#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{

/// A lower bound (sharp to round-off) of the smallest eigenvalue s of a law in Mandel form, so that
/// |eps|^2 <= K eps : eps / s; 2 mu for isotropic materials.
double smallestStiffness(const Elasticity& law);

} // namespace ndframe
