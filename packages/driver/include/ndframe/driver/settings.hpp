#pragma once

#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// Reads a validated deck; what only its components need stays in it. Lists that contradict each other are read as
/// well as they can be: checkDeck and runDeck refuse them.
RunSettings readSettings(const Params& deck);

} // namespace ndframe
