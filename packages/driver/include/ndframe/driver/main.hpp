#pragma once

#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// Exit codes of the program.
enum class ExitCode
{
  Right = 0,
  Bug = 1,
  UserInput = 2,
  NotConverged = 3, ///< or a bound without the guarantee that the deck requires, or no certificate
  ExpectationMissed = 4,
  TargetMissed = 5, ///< the list Accuracy; what was reached is certified
  Warned = 6        ///< the answer shows what Strict Input does not allow; it is written
};

/// The whole program: reads the command line, runs the deck, writes the results. A project with components of its own
/// calls it from its main with an extension that registers them.
int runMain(int argc, char** argv, const Extension& extend = {});

} // namespace ndframe
