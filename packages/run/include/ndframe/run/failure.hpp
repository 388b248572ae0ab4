#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ndframe/algebra/comm.hpp"

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

/// What an exception is to the user.
struct Failure
{
  ExitCode code = ExitCode::Bug; ///< that it makes the program end with
  std::string text;              ///< for the user, without a last newline
  std::size_t mistakes = 0;      ///< in the user's input
  bool outOfMemory = false;      ///< then there is no text: it would need memory
};

/// What is said of a deck that the process has too little memory for.
constexpr const char* needsMoreMemory = "this deck needs more memory than the process may use; use a coarser mesh, "
                                        "fewer threads (OMP_NUM_THREADS), more ranks or Multigrid as linear solver.";

/// The exception that is being handled; to be called in a handler.
Failure currentFailure();

/// What went wrong in steps that others may follow; none when they were done. With several ranks a bug and a lack of
/// memory pass through, as the other ranks may know nothing of them.
std::optional<Failure> failureIn(const Comm& comm, const std::function<void()>& steps);

} // namespace ndframe
