#include "ndframe/base/memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace ndframe
{
namespace
{

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

/// The number after `key` in a file of "key number" lines, or the first word of the file where the key is empty.
std::optional<std::int64_t> numberIn(const std::string& path, const std::string& key = {})
{
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    std::int64_t number = 0;
    if (!key.empty() && (!(words >> name) || name != key))
      continue;
    if (words >> number)
      return number;
    return std::nullopt; // "max"
  }
  return std::nullopt;
}

/// How the files of a version of control groups are called.
struct GroupFiles
{
  const char *limit, *used, *droppable;
};

constexpr GroupFiles version1{"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles version2{"/memory.max", "/memory.current", "inactive_file"};

/// What a group leaves, or the ones above it. A container may see its own group as the topmost.
std::int64_t leftInGroups(const std::string& mount, std::string group, const GroupFiles& files)
{
  std::int64_t left = unlimited;
  for (;;) {
    const std::string folder = mount + (group == "/" ? "" : group);
    const auto limit = numberIn(folder + files.limit), used = numberIn(folder + files.used);
    if (limit && used) // without a limit, version 1 shows a number beyond all memories
      left = std::min(left, std::max<std::int64_t>(
                                0, *limit - *used + numberIn(folder + "/memory.stat", files.droppable).value_or(0)));
    if (group.empty() || group == "/")
      return left;
    group.erase(group.rfind('/'));
  }
}

std::int64_t leftInContainer(const std::string& root)
{
  std::int64_t left = unlimited;
  std::ifstream groups(root + "/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) { // "0::/a/b" or "7:memory:/a/b"
    const auto first = line.find(':'), second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty())
      left = std::min(left, leftInGroups(root + "/sys/fs/cgroup", group, version2));
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
      left = std::min(left, leftInGroups(root + "/sys/fs/cgroup/memory", group, version1));
  }
  return left;
}

std::int64_t leftUnder(decltype(RLIMIT_AS) what, const char* used)
{
  rlimit limit{};
  if (getrlimit(what, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return unlimited;
  const std::int64_t kilobytes = numberIn("/proc/self/status", used).value_or(0);
  return std::max<std::int64_t>(0, std::int64_t(limit.rlim_cur) - (kilobytes << 10));
}

} // namespace

std::string MemoryLeft::text() const
{
  return limit.empty() ? "an unknown amount" : fmt::format("{:.3g} GB ({})", 1e-9 * double(bytes), limit);
}

MemoryLeft memoryLeft(const std::string& root)
{
  MemoryLeft left{unlimited, {}};
  const auto atMost = [&](std::int64_t bytes, const char* limit) {
    if (bytes < left.bytes)
      left = {bytes, limit};
  };
  if (const auto kilobytes = numberIn(root + "/proc/meminfo", "MemAvailable:"))
    atMost(*kilobytes << 10, "the machine");
  atMost(leftInContainer(root), "the container (cgroup)");
  if (root.empty()) {
    atMost(leftUnder(RLIMIT_AS, "VmSize:"), "ulimit -v");
    atMost(leftUnder(RLIMIT_DATA, "VmData:"), "ulimit -d");
    if (!left.limit.empty())
      left.bytes += std::int64_t(mallinfo2().fordblks); // freed and kept by this process
  }
  return left;
}

void useLargePages(void* block, std::size_t bytes)
{
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const auto first = (reinterpret_cast<std::uintptr_t>(block) + page - 1) / page * page;
  const auto last = (reinterpret_cast<std::uintptr_t>(block) + bytes) / page * page;
  if (first < last)
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE); // advice: where it fails, nothing is lost
}

} // namespace ndframe
