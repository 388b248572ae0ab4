#pragma once

#include "ndframe/run/failure.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What a run that came to its end is to the user: the gravest of what is wrong with it.
ExitCode codeOf(const Run& run);

/// Says what happened and returns the exit code. Every rank meets a user's mistake and an iteration that does not
/// converge; a bug or a lack of memory may be one rank's: it speaks, and all processes end at once. `computed`: the
/// deck had been solved before.
ExitCode report(const Failure& failure, bool computed, const Comm& comm);

/// Errors and misses go to the standard error stream, also with -q; one rank speaks.
void complain(const Comm& comm, const std::string& text);

} // namespace ndframe
