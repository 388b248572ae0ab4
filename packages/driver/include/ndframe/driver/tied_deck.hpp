#pragma once

#include "ndframe/base/deck.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

/// validate(), for a deck in which interfaces may be tied: the bodies that tied interfaces join become one, called "A +
/// B", whose mesh is Tied and whose regions are the bodies; supports, loads and other interfaces follow. Mistakes are
/// those of the deck as it was written.
Params validateScene(const DeckList& deck, const ListSpec& spec, Diagnostics& diagnostics);

} // namespace ndframe
