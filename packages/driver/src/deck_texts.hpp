#pragma once

#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"

namespace ndframe
{

// What is read of a deck before it is validated.

/// Without blanks at its ends.
std::string trimmed(const std::string& text);

/// The trimmed parts between separators.
std::vector<std::string> partsOf(const std::string& text, const std::string& separator);

/// A path without the blanks that settings may have around names.
std::string plainPath(const std::string& path);

/// An entry of the list Output; empty where the deck has none.
std::string outputEntry(const DeckList& deck, const std::string& name);

/// As Output/Name says; else the deck's file without its ending.
std::string fileNameOf(const DeckList& deck, const std::string& deckName);

} // namespace ndframe
