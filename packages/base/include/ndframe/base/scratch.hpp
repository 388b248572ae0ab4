#pragma once

#include <filesystem>

namespace ndframe
{

/// A file or folder that is removed when this object goes, or when a signal ends the process before that
/// (removeScratch). Nothing happens when it does not exist, so it may be made later or renamed.
class Scratch
{
public:
  explicit Scratch(std::filesystem::path path);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
  int slot_; ///< where a signal handler finds it; -1 when all places were taken
};

/// Removes all scratch files, and all scratch folders that hold nothing else. Safe in a signal handler.
void removeScratch() noexcept;

} // namespace ndframe
