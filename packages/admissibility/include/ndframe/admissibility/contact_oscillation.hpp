#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// What the stresses leave over of t n where n turns along a patch: t n has one degree more than t. Per body and cell
/// osc_E^2 with |int (t n - carried) . v dS| <= osc_E |v|_E over the cell's patches, in the energy norm: the energy of
/// a stress of degree 3 that carries the rest, and the facet's constant (docs/theory.md) for what has a higher degree
/// than that; ByConstants: in solids constants for all of it. Empty where nothing turns.
std::vector<CellValues> contactOscillation(const std::vector<const BodyModel*>& bodies,
                                           const std::vector<ContactPatch>& patches, const ContactTraction& traction,
                                           OscillationBound bound = OscillationBound::Sharp);

} // namespace ndframe
