#include "automatic_list.hpp"

#include <algorithm>

#include "ndframe/base/changed_params.hpp"
#include "ndframe/base/list_specs.hpp"

namespace ndframe
{
namespace
{

constexpr const char* distance = "Distance";
constexpr const char* leaveOut = "Leave Out";

/// Parameters of an interface that say which sides meet, or what is special about these two.
bool isOfOnePair(const ParamSpec& param)
{
  const auto startsWith = [&](const char* word) { return param.name.rfind(word, 0) == 0; };
  return startsWith("Dirichlet ") || startsWith("Neumann ") || param.name == "Gap" || param.name == "Tied";
}

} // namespace

ListSpec automaticSpec(const ListSpec& interface)
{
  ListSpec list = makeList(
      "Automatic",
      "Finds the named sides that face each other in the plane, of different bodies or two of one, in space those that "
      "lie on each other, and makes an interface of every two, as if the deck had it. The screen says what was "
      "found, as a table "
      "and as text of a deck (of more than "
      "ten with -v). The body that the deck names first is the Dirichlet body. What other lists of Interfaces say "
      "of two sides counts instead. Of sides that share facets those count that other lists name, then the parts "
      "of a side that make all of it, then the longer ones. Not found: a side that faces itself, sides behind "
      "other bodies, facets without a named side (a warning), rigid bodies.");
  list.onlyIfGiven = true;
  list.params = {ParamSpec::optional(distance, Kind::Double, atLeast(0.0),
                                     "Largest opening of sides that face each other: along the normals of the first "
                                     "one, on some of its length, where they enclose less than 25 degrees. 0: sides "
                                     "that touch, but for what chords of curves are apart. Without it: 1 % of the "
                                     "diagonal of the box around all bodies. In the plane only."),
                 {leaveOut, std::vector<std::string>{}, "Sides that face nothing, as \"BODY/SIDE\"."}};
  for (const ParamSpec& param : interface.params)
    if (!isOfOnePair(param))
      list.params.push_back(param);
  return list;
}

bool findsInterfaces(const Params& deck)
{
  return deck.sub("Interfaces").hasSub("Automatic");
}

std::vector<DeckEntry> sharedEntries(const Params& automatic)
{
  std::vector<DeckEntry> entries = givenEntries(automatic);
  const auto isOwn = [](const DeckEntry& entry) { return entry.name == distance || entry.name == leaveOut; };
  entries.erase(std::remove_if(entries.begin(), entries.end(), isOwn), entries.end());
  return entries;
}

} // namespace ndframe
