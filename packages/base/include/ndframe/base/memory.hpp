#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace ndframe
{

/// Memory that this process can still take.
struct MemoryLeft
{
  std::int64_t bytes = 0; ///< the largest number where nobody tells
  std::string limit;      ///< who sets it: "the machine", "the container (cgroup)", "ulimit -v", "ulimit -d"

  /// "7.9 GB (the machine)"
  std::string text() const;
};

/// The least of what is free on the machine without swapping (MemAvailable), what the control groups of this process
/// (versions 1 and 2, all levels) leave, files that they can drop taken as free, and what its own limits leave, with
/// what it has freed and keeps. `root`: where /proc and /sys are looked for; the limits are then left out.
MemoryLeft memoryLeft(const std::string& root = "");

/// Asks for pages of 2 MB in the part of a block that they fill, before it is written: products with a matrix in small
/// pages take 1.7 times the time. Nothing stays empty.
void useLargePages(void* block, std::size_t bytes);

} // namespace ndframe
