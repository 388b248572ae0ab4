#include "case_expectations.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/help.hpp"

namespace ndframe
{
namespace
{

/// Before the name of the case whose number an expectation asks for.
const std::string ofCases = "cases/";

} // namespace

void checkExpectations(const DeckList& deck, const std::vector<std::string>& names, Diagnostics& diagnostics)
{
  const DeckList* const expect = deck.findList("Expect");
  if (expect == nullptr)
    return;
  for (const DeckList& list : expect->lists) {
    const DeckEntry* const quantity = list.findEntry("Quantity");
    if (quantity == nullptr || quantity->value.rfind(ofCases, 0) != 0)
      continue;
    const std::string rest = quantity->value.substr(ofCases.size()), name = rest.substr(0, rest.find('/'));
    if (std::find(names.begin(), names.end(), name) != names.end())
      continue;
    const std::string near = nearestName(name, names);
    diagnostics.add({quantity->file.empty() ? "--set" : quantity->file, quantity->line, "Expect/" + list.name,
                     fmt::format("there is no case \"{}\"{}", name,
                                 near.empty() ? fmt::format("; the cases are {}.", fmt::join(names, ", "))
                                              : fmt::format("; did you mean \"{}\"?", near))});
  }
}

void keepExpectations(DeckList& deck, const std::string& name)
{
  for (DeckList& list : deck.lists) {
    if (list.name != "Expect")
      continue;
    const std::string own = ofCases + name + "/";
    std::vector<DeckList> kept;
    for (DeckList expectation : list.lists) {
      bool belongs = true;
      for (DeckEntry& entry : expectation.entries) {
        const bool ofOne = entry.name == "Quantity" && entry.value.rfind(ofCases, 0) == 0;
        belongs = belongs && (!ofOne || entry.value.rfind(own, 0) == 0);
        if (ofOne && belongs)
          entry.value.erase(0, own.size());
      }
      if (belongs)
        kept.push_back(expectation);
    }
    list.lists = std::move(kept);
  }
}

} // namespace ndframe
