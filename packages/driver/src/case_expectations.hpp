#pragma once

#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"

namespace ndframe
{

/// Refuses expectations of load cases that there are not.
void checkExpectations(const DeckList& deck, const std::vector<std::string>& names, Diagnostics& diagnostics);

/// Leaves the expectations of one case, and of all: the quantity "cases/half/energy" is "energy" of the case half.
void keepExpectations(DeckList& deck, const std::string& name);

} // namespace ndframe
