#pragma once

#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{

/// contact: the body's facets on interfaces, in the order in which fields give tractions. negligible: an energy norm;
/// where the constants bound all of a plane body's oscillation by less, there is no stress of the richest degree.
StaticData makeStaticData(const BodyModel& body, int degree, std::vector<Facet> contact, double negligible = 0.0);

} // namespace ndframe
