#pragma once

#include <string>

#include "ndframe/base/param_spec.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// Everything a deck may contain: the source of validation, help and docs/reference.md.
ListSpec makeDeckSpec(const Components& components);

/// A small deck that runs, for --dump-defaults.
std::string defaultDeck();

} // namespace ndframe
