#pragma once

#include "ndframe/mechanics/cell_laws.hpp"

namespace ndframe
{

/// A lower bound (sharp to round-off) of the smallest eigenvalue s of a law in Mandel form, so that
/// |eps|^2 <= K eps : eps / s; 2 mu for isotropic materials.
double smallestStiffness(const Elasticity& law);

/// The same of each of the laws of a body.
std::vector<double> smallestStiffness(const CellLaws& laws);

} // namespace ndframe
