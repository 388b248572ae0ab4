#pragma once

#include <cstdint>

namespace ndframe
{

/// The hash of one number more. Not for what an adversary chooses.
constexpr std::uint64_t mixedHash(std::uint64_t hash, std::uint64_t next)
{
  return (hash ^ next) * 0x9e3779b97f4a7c15u ^ (hash >> 29);
}

} // namespace ndframe
