#pragma once

#include <cstddef>
#include <cstdint>

namespace ndframe
{

/// FNV-1a, 64 bits (Fowler, Noll, Vo): the same on all machines, so that files may keep it. Not for what an adversary
/// chooses. hash: that of the bytes before.
inline std::uint64_t byteHash(const void* data, std::size_t size, std::uint64_t hash = 0xcbf29ce484222325u)
{
  const auto* const bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i)
    hash = (hash ^ bytes[i]) * 0x100000001b3u;
  return hash;
}

} // namespace ndframe
