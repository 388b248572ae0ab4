#pragma once

#include <vector>

namespace ndframe
{

/// A commented deck that runs as it stands.
struct DeckTemplate
{
  const char* name;
  const char* what; ///< in a few words
  const char* text;
};

const std::vector<DeckTemplate>& deckTemplates();

} // namespace ndframe
