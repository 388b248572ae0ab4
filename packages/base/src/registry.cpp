#include "ndframe/base/registry.hpp"

#include "ndframe/base/deck.hpp"

namespace ndframe
{

Params validatedChoice(const std::string& name, const Choices& choices, const std::vector<std::string>& settings)
{
  ListSpec spec;
  spec.name = name;
  spec.choices = choices;
  DeckList list;
  list.name = name;
  Diagnostics diagnostics;
  for (const std::string& setting : settings)
    applySetting(list, setting, diagnostics);
  Params params = validate(list, spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

} // namespace ndframe
