#pragma once

#include <string>
#include <vector>

#include "ndframe/base/params.hpp"

namespace ndframe
{

// Validated lists made of others, for what is to look as if the deck had said it.

/// The entries that the user gave, as they would stand in a deck.
std::vector<DeckEntry> givenEntries(const Params& list);

/// The list without what was not given: toXml() of it is what a user would have written.
Params withoutDefaults(const Params& list);

/// Lists with other sublists in their list `name`, which they have.
Params withSublists(const Params& lists, const std::string& name, const std::vector<Params>& sublists);

} // namespace ndframe
