#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace ndframe
{

/// A file that must stay as it is while a reader, which may open it several times, makes a mesh of it: half of an old
/// and half of a new file can look sound. Files that do not exist are left to who opens them.
class SteadyFile
{
public:
  /// FileError unless it is a regular file: a pipe could wait for ever, a device never end.
  explicit SteadyFile(const std::string& path);

  /// FileError when the file has changed since. Limit: it looks at the size and the time of the last change, which
  /// moves on in steps of some milliseconds.
  void requireUnchanged() const;

private:
  struct Stamp
  {
    std::uintmax_t size;
    std::filesystem::file_time_type written;
  };
  Stamp stamp() const;

  std::string path_;
  Stamp before_;
};

/// The bytes of a file; FileError when it cannot be read.
std::string readText(const std::string& path);

} // namespace ndframe
