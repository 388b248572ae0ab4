#pragma once

#include <string>

#include "spec_view.hpp"

namespace ndframe
{

/// A list of the specification as it stands in a deck being checked.
struct ListContext
{
  const ListSpec& root;           ///< of the whole deck
  const ListSpec& spec;           ///< of this list
  const ComponentInfo* component; ///< chosen by "Type"; null when there is no choice or it is not known
  SpecView view;                  ///< what the list may hold with this component
};

/// What to tell a user who wrote a key that the list does not have: where it belongs, what it may have been meant to
/// be, or what is valid here. Empty when the key may belong to a component that a wrong "Type" hides.
std::string unknownKeyMessage(const ListContext& context, const std::string& key);

/// The same for a sublist.
std::string unknownListMessage(const ListContext& context, const std::string& list);

/// True when one of the given names was answered with "did you mean `name`": it need not be called missing as well.
bool isMisspelt(const std::vector<std::string>& given, const std::vector<std::string>& valid, const std::string& name);

} // namespace ndframe
