#pragma once

#include "ndframe/driver/components.hpp"
#include "ndframe/run/failure.hpp"

namespace ndframe
{

/// The whole program: reads the command line, runs the deck, writes the results. A project with components of its own
/// calls it from its main with an extension that registers them.
int runMain(int argc, char** argv, const Extension& extend = {});

} // namespace ndframe
