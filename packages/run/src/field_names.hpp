#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Refuses names of bodies, sides and interfaces that are too long for NAME.e, if the deck wants it.
void checkFieldNames(const Model& model, const Params& deck, Diagnostics& diagnostics);

} // namespace ndframe
