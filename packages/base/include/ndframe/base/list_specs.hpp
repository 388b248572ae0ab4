#pragma once

#include <string>

#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// A list of the deck that is filled with its defaults where it is absent.
ListSpec makeList(std::string name, std::string doc);

/// The same, of a component that the key "Type" chooses.
ListSpec makeChoice(std::string name, std::string doc, const Choices& choices);

} // namespace ndframe
