#pragma once

#include <filesystem>

namespace ndframe
{

/// A file or folder that is removed, with all that is in it, when this object goes, or when a signal ends the process
/// before that (removeScratch). Nothing happens when it does not exist, so it may be made later or renamed.
class Scratch
{
public:
  explicit Scratch(std::filesystem::path path); ///< makes nothing
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; } ///< as given; may not exist

private:
  std::filesystem::path path_;
};

/// Removes the files and folders of all objects of this process. For a thread of its own: it allocates and locks, which
/// a signal handler must not.
void removeScratch();

} // namespace ndframe
