#include "ndframe/algebra/from_rank_zero.hpp"

#include <optional>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

std::string fromRankZero(const Comm& comm, const std::function<std::string()>& make)
{
  std::string bytes; // stays empty when there are none to be had
  std::optional<InputError> failure;
  if (comm.rank() == 0) {
    try {
      bytes = make();
    } catch (const InputError& error) {
      failure = error;
    }
  }
  comm.broadcast(bytes);
  if (bytes.empty())
    throw failure ? *failure : InputError("rank 0 could not do its part"); // only rank 0 speaks
  return bytes;
}

} // namespace ndframe
