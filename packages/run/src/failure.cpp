#include "ndframe/run/failure.hpp"

#include <new>
#include <system_error>

#include <fmt/format.h>

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

Failure notConverged(const std::exception& error)
{
  return {ExitCode::NotConverged, fmt::format("not converged: {}", error.what())};
}

Failure bug(const std::exception& error)
{
  return {ExitCode::Bug, fmt::format("a bug in ndframe: {}\nPlease report it together with the deck.", error.what())};
}

Failure lackOfMemory()
{
  return {ExitCode::UserInput, {}, 0, true};
}

} // namespace

Failure currentFailure()
{
  try {
    throw;
  } catch (const InputError& error) {
    return {ExitCode::UserInput, error.what(), error.list().size()};
  } catch (const NotConverged& error) {
    return notConverged(error);
  } catch (const SingularBody& error) { // met by an iterative solver on its way
    return notConverged(error);
  } catch (const std::bad_alloc&) {
    return lackOfMemory();
  } catch (const std::system_error& error) {
    const bool isThreadsStack = error.code() == std::errc::resource_unavailable_try_again;
    return isThreadsStack ? lackOfMemory() : bug(error);
  } catch (const std::exception& error) {
    return bug(error);
  }
}

std::optional<Failure> failureIn(const Comm& comm, const std::function<void()>& steps)
{
  try {
    steps();
    return std::nullopt;
  } catch (...) {
    const Failure failure = currentFailure();
    if (comm.size() > 1 && (failure.code == ExitCode::Bug || failure.outOfMemory))
      throw;
    return failure;
  }
}

} // namespace ndframe
