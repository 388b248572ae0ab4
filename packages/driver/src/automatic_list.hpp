#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/params.hpp"

namespace ndframe
{

/// The list "Automatic" of Interfaces. interface: the list of one interface, whose parameters it shares but for what
/// names bodies and sides.
ListSpec automaticSpec(const ListSpec& interface);

/// Whether the deck has that list.
bool findsInterfaces(const Params& deck);

/// The entries of the list that go on to every interface that is found.
std::vector<DeckEntry> sharedEntries(const Params& automatic);

} // namespace ndframe
