#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ndframe
{

/// What a child process may take; it inherits the rest from its parent.
struct ChildLimits
{
  std::int64_t extraBytes = 0; ///< memory beyond what the parent has at the start; 0: no limit
  int cpuSeconds = 0;          ///< 0: no limit
};

/// Runs `work` in a child process and returns what it returns. A library that crashes on a damaged file, never ends or
/// takes all memory ends only the child: FileError naming `library`. A FileError of the child is thrown here again, any
/// other exception becomes an InternalError with its message. Nothing else that `work` changes is seen here; the child
/// ends with this process.
std::string runInChild(const std::function<std::string()>& work, const std::string& library, ChildLimits limits = {});

} // namespace ndframe
