#pragma once

#include <string>
#include <vector>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// What one list of a deck may hold once its component is known: the keys ("Type" first) and the sublists with fixed
/// names, its own and the component's.
struct SpecView
{
  std::vector<ParamSpec> params;
  std::vector<const ListSpec*> lists;

  const ParamSpec* findParam(const std::string& name) const;
  const ListSpec* findList(const std::string& name) const;
  std::vector<std::string> paramNames() const;
  std::vector<std::string> listNames() const;
};

/// `component` may be null: none chosen, or not known.
SpecView viewOf(const ListSpec& spec, const ComponentInfo* component);

/// The key "Type" as the choices define it.
ParamSpec typeParam(const Choices& choices);

/// The component of that name, null when there is none.
const ComponentInfo* findComponent(const ListSpec& spec, const std::string& name);

std::vector<std::string> componentNames(const Choices& choices);

/// One list of the whole specification with its place in a deck.
struct PlacedList
{
  std::string path; ///< "Bodies/*/Material"; "*" stands for the user's names; empty: the deck itself
  const ListSpec* spec = nullptr;
  const ComponentInfo* owner = nullptr; ///< the component that brings the list, if one does
};

/// The list and all lists below it, depth first in the order of the specification.
std::vector<PlacedList> allLists(const ListSpec& root);

/// "Coupling" and "Stopping" -> "Coupling/Stopping"; an empty parent is the deck itself.
std::string joinPath(const std::string& parent, const std::string& name);

} // namespace ndframe
