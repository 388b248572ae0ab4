#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/driver/main.hpp"
#include "ndframe/driver/run.hpp"

namespace ndframe
{

/// What an exception is to the user.
struct Failure
{
  ExitCode code = ExitCode::Bug;
  std::string text;
  std::size_t mistakes = 0; ///< in the user's input
  bool outOfMemory = false; ///< then there is no text: it would need memory
};

/// What is said of a deck that the process has too little memory for.
constexpr const char* needsMoreMemory =
    "this deck needs more memory than the process may take; use a coarser mesh, fewer threads (OMP_NUM_THREADS), more "
    "ranks or a Krylov solver.";

/// The exception that is being handled; to be called in a handler.
Failure currentFailure();

/// What went wrong in steps that others may follow; none when they were done. With several ranks a bug and a lack of
/// memory pass through, as the other ranks may know nothing of them.
std::optional<Failure> failureIn(const Comm& comm, const std::function<void()>& steps);

/// What a run that came to its end is to the user: the gravest of what is wrong with it.
ExitCode codeOf(const Run& run);

/// Says what happened and returns the exit code. Every rank meets a user's mistake and an iteration that does not
/// converge; a bug or a lack of memory may be one rank's: it speaks, and all processes end at once. `computed`: the
/// deck had been solved before.
ExitCode report(const Failure& failure, bool computed, const Comm& comm);

/// Errors and misses go to the standard error stream, also with -q; one rank speaks.
void complain(const Comm& comm, const std::string& text);

} // namespace ndframe
