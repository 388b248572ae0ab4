#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

/// What a child process may take; it inherits the rest from its parent.
struct ChildLimits
{
  std::int64_t extraBytes = 0; ///< memory beyond what the parent has at the start; 0: no limit
  int cpuSeconds = 0;          ///< 0: no limit
  int wallSeconds = 0;         ///< for children that wait, which takes no processor time; 0: no limit; at most 2e6
  bool mayStartPrograms = true;
};

/// Bytes that this process and its children can still take (memoryLeft()); 0 where the system does not tell.
std::int64_t freeMemory();

/// A child process ended without an answer.
class ChildFailure final : public FileError
{
public:
  enum class Kind
  {
    OutOfTime, ///< processor time
    Waits,     ///< it takes none and does not end
    OutOfMemory,
    Exited, ///< the library ended its process
    Crashed,
    StartsProgram, ///< one that may not
    Unwatched      ///< it may start no program, and the system offers no way to see to that
  };

  ChildFailure(Kind kind, const std::string& message) : FileError(message), kind_(kind) {}
  Kind kind() const { return kind_; }

private:
  Kind kind_;
};

/// Runs `work` in a child process and returns what it returns. A library that crashes on a damaged file, never ends,
/// takes all memory or exits ends only the child: ChildFailure naming `library`. A FileError of the child is thrown
/// here again, any other exception becomes an InternalError with its message. Nothing else that `work` changes is seen
/// here; the child ends with this process.
std::string runInChild(const std::function<std::string()>& work, const std::string& library, ChildLimits limits = {});

} // namespace ndframe
