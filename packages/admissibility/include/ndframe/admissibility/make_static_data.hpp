#pragma once

#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{

/// How the data's oscillation is bounded.
enum class OscillationBound
{
  Sharp,
  ByConstants ///< cheaper and larger; sharpenOscillation() may follow
};

/// contact: the body's facets on interfaces, in the order in which fields give tractions.
StaticData makeStaticData(const BodyModel& body, int degree, std::vector<Facet> contact,
                          OscillationBound bound = OscillationBound::Sharp);

/// Bounds the oscillation by the energy of the stress that carries most of it. Nothing to do where it is sharp already.
void sharpenOscillation(const BodyModel& body, StaticData& data);

} // namespace ndframe
