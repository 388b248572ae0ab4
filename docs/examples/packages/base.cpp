// Adds a component of its own to a registry, builds it from a deck, and reports a misspelt key with its line.
#include "ndframe/base/registry.hpp"

struct Spring // what the components make
{
  double stiffness;
};

int main()
{
  using namespace ndframe;
  Registry<Spring> springs("spring", "Bar");
  springs.add("Bar", "A bar of length 1.",
              {{"Young Modulus", 210.0, above(0.0), "E."}, {"Area", 1.0, above(0.0), "Of its cross-section."}},
              [](const Params& list) {
                return std::make_unique<Spring>(Spring{list.get<double>("Young Modulus") * list.get<double>("Area")});
              });
  ListSpec spec;
  spec.choices = springs.choices();

  DeckList deck =
      parseDeck("<ParameterList>\n<Parameter name=\"Area\" type=\"double\" value=\"3\"/>\n</ParameterList>", "bar.xml");
  Diagnostics mistakes;
  applySetting(deck, "Young Modulus=70", mistakes); // as `--set` does
  const Params bar = validate(deck, spec, mistakes);
  mistakes.throwIfAny();
  const bool isBuilt = springs.build(bar)->stiffness == 210.0 && !bar.isGiven("Type");

  deck.entries[0].name = "Aera";
  validate(deck, spec, mistakes);
  return isBuilt && mistakes.list().size() == 1 && mistakes.list()[0].line == 2 ? 0 : 1;
}
