#pragma once

#include <string>
#include <vector>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// What `ndframe --check` would say against a deck, on one process; empty: the deck is right. file: where it will be,
/// from whose folder its meshes are named. Meshes are read or made, nothing is solved.
std::vector<Diagnostic> mistakesOfDeck(const std::string& deck, const std::string& file, const Components& components);

} // namespace ndframe
