#pragma once

#include <string>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// The value of an entry, of the kind and in the range that its spec wants. An entry without type (`--set`) takes the
/// spec's. Throws std::invalid_argument with a sentence for the user.
Value checkedValue(const DeckEntry& entry, const ParamSpec& spec);

/// The value of an entry that no spec describes, by the type it states or, without one, by what it looks like.
/// Throws std::invalid_argument with a sentence for the user.
Value statedValue(const DeckEntry& entry);

/// "Theta is missing (double, in (0, 2))."
std::string missingMessage(const ParamSpec& spec);

} // namespace ndframe
