#pragma once

#include <chrono>
#include <optional>

#include "command_line.hpp"
#include "failures.hpp"

namespace ndframe
{

/// True where colours, and a line that is drawn and erased again, disturb nobody: on a terminal that knows how to and
/// is not told not to (NO_COLOR), and not below a launcher, which gives its processes terminals and writes what they
/// say to files. `stream`: its descriptor.
bool mayDraw(int stream, const Comm& comm);

/// The option --live, if it is given.
std::optional<std::chrono::milliseconds> patienceOf(const CommandLine& options);

/// Begins the file of --log, if there is one: rank 0 writes it. Throws InputError on all ranks where it cannot be
/// written or is the deck. Collective.
void beginTranscript(const CommandLine& options, const Comm& comm);

/// The code of a run whose screen or file of --log could not be written; that file ends here.
ExitCode checkScreen(ExitCode code, const Comm& comm);

} // namespace ndframe
