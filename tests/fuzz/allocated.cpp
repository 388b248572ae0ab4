#include "fuzz/allocated.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace
{

std::atomic<std::size_t> now{0};
std::atomic<std::size_t> peak{0};

} // namespace

// The C++ library's other forms of new and delete call these; with the address sanitizer this one would not.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void* operator new(std::size_t size)
{
  void* const place = std::malloc(std::max<std::size_t>(size, 1));
  if (place == nullptr)
    throw std::bad_alloc();
  const std::size_t bytes = now += malloc_usable_size(place);
  if (bytes > peak)
    peak = bytes;
  return place;
}

void operator delete(void* place) noexcept
{
  now -= malloc_usable_size(place);
  std::free(place);
}

void operator delete(void* place, std::size_t) noexcept
{
  operator delete(place);
}

namespace ndframe::test
{

std::size_t allocatedBytes()
{
  return now;
}

std::size_t takePeakBytes()
{
  return peak.exchange(now.load());
}

} // namespace ndframe::test
