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
      "Finds the named sides, of different bodies or of one, that face each other in 2D or lie on each other in 3D, "
      "and makes an interface of each pair, as if the deck had it. The screen shows what was found, as a table and as "
      "deck text (more than ten only with -v). The body that the deck names first is the Dirichlet body. What other "
      "lists of Interfaces say about two sides takes precedence. Of sides that share facets, those that other lists "
      "name come first, then the parts of a side that make up all of it, then the longer ones. Not found: a side that "
      "faces itself, sides behind other bodies, facets without a named side (a warning), rigid bodies.");
  list.onlyIfGiven = true;
  list.params = {
      ParamSpec::optional(
          distance, Kind::Double, atLeast(0.0),
          "Largest opening between sides that face each other, along the normals of the first one, over part of its "
          "length, where they enclose less than 25 degrees. 0: sides that touch, except for the distance between "
          "chords of curves. Default: 1 % of the diagonal of the box around all bodies. In 2D only."),
      {leaveOut, std::vector<std::string>{}, "Sides to be left out, as \"BODY/SIDE\"."}};
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
