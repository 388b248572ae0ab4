#include "ndframe/base/scratch.hpp"

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <string>

#include <unistd.h>

namespace ndframe
{

namespace
{

/// Paths at fixed addresses: a signal handler may neither allocate nor lock.
struct Slot
{
  enum State
  {
    Free,
    Reserved,
    Filled
  };
  std::atomic<int> state{Free};
  std::array<char, PATH_MAX> path{};
};

std::array<Slot, 8> slots;

int takeSlot(const std::string& path)
{
  for (std::size_t s = 0; s < slots.size() && path.size() < PATH_MAX; ++s) {
    int expected = Slot::Free;
    if (!slots[s].state.compare_exchange_strong(expected, Slot::Reserved))
      continue;
    std::memcpy(slots[s].path.data(), path.c_str(), path.size() + 1);
    slots[s].state = Slot::Filled;
    return int(s);
  }
  return -1;
}

} // namespace

Scratch::Scratch(std::filesystem::path path) : path_(std::move(path)), slot_(takeSlot(path_.string())) {}

Scratch::~Scratch()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (slot_ >= 0)
    slots[std::size_t(slot_)].state = Slot::Free;
}

void removeScratch() noexcept
{
  // From the last one: the files in a scratch folder come after it.
  for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot)
    if (slot->state == Slot::Filled && unlink(slot->path.data()) != 0)
      rmdir(slot->path.data());
}

} // namespace ndframe
