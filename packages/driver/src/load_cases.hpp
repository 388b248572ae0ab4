#pragma once

#include <string>

#include "study_cases.hpp"

namespace ndframe
{

/// The list Load Cases.
ListSpec loadCasesSpec();

/// Expands the deck's list Load Cases: the deck of a case is the deck with the data that its factors multiply. Without
/// the list Accuracy the cases have the same meshes and share their files. Every case is validated like a deck; the
/// mistakes of all cases are collected. `deckName`: the deck's file.
Study expandLoadCases(const DeckList& deck, const std::string& deckName, const ListSpec& spec,
                      Diagnostics& diagnostics);

} // namespace ndframe
