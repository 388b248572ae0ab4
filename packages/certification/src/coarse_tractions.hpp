#pragma once

#include "certificate_steps.hpp"

namespace ndframe
{

/// Nodal tractions that may stand for the computed one where sides do not match: the given one and, for each side, the
/// nearest one in L2 (on every interface with a map) that is a polynomial on every facet as it was before it was cut.
/// Where a facet faces a much shorter one of a stiff body, what the cut mesh gives swings; these do not.
/// Sides that were not cut add nothing.
std::vector<Vector> tractionsOfSides(const CertifiedScene& scene, const Vector& nodal);

} // namespace ndframe
