#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "ndframe/base/scratch.hpp"

namespace ndframe
{

/// Writes a file under a temporary name in the same folder, then renames it: nobody ever sees half a file.
///
/// `write` gets the temporary path and throws on failure; the temporary file is then removed. Its std::runtime_error, a
/// missing or unwritable folder, a full disk or a target that is no regular file end as InputError naming `path` and
/// the reason; other exceptions (bugs) pass through. Returns the number of bytes written. The temporary file is a
/// Scratch, so signals leave none behind; after SIGKILL it stays until the same file is written again on this machine.
/// Limit: no fsync, so it guards against a crash of the program, not of the machine.
std::int64_t writeAtomically(const std::string& path,
                             const std::function<void(const std::string& temporaryPath)>& write);

/// Calls `write`, which writes to `path`: what stands in the way of a file is a mistake of the user's, as above.
void orCannotWrite(const std::string& path, const std::function<void()>& write);

/// The same for a text.
std::int64_t writeTextAtomically(const std::string& path, const std::string& text);

/// The two halves of writeAtomically, for files of which all shall appear or none: each is written first and kept when
/// all are complete. What is not kept is removed.
class PendingFile
{
public:
  /// Writes the temporary file. Throws InputError as writeAtomically does.
  PendingFile(std::string path, const std::function<void(const std::string& temporaryPath)>& write);
  std::int64_t bytes() const { return bytes_; } ///< that were written
  std::string temporary() const { return temporary_.path().string(); }
  void keep(); ///< renames it; throws InputError

private:
  std::string path_;
  Scratch temporary_;
  std::int64_t bytes_ = 0;
};

/// Characters that the name of a file may have, its temporary name included.
std::size_t longestFileName();

/// Removes the file that a writer would have replaced, and what a killed writer left of it. Without one it does
/// nothing; InputError when there is one that cannot be removed.
void removeEarlier(const std::string& path);

} // namespace ndframe
