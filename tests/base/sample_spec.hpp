#pragma once

#include <string>

#include "ndframe/base/param_spec.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe::test
{

/// A small specification with everything that one can hold: all kinds, required, optional and defaulted keys, lists
/// that are required, optional, only if given, named by the user, chosen by "Type", or handed on to a library.
ListSpec sampleSpec();

/// A right deck that writes the required keys only.
std::string smallestDeck();

/// A right deck that writes nearly everything.
std::string fullDeck();

/// Parses and validates; throws InputError with all mistakes.
Params validated(const std::string& xml, const ListSpec& spec = sampleSpec());

/// The text of the InputError that the deck (named "deck.xml") is answered with; empty when it is right.
std::string complaint(const std::string& xml);

} // namespace ndframe::test
