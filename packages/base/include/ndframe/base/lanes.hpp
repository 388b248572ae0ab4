#pragma once

#include <cstring>

/// Compiles a function once for every level of x86-64; the loader takes the best one that the machine has. By levels,
/// not by names of processors ("haswell"): a name is recognised on that model alone, and not in virtual machines.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NDFRAME_EVERY_PROCESSOR __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define NDFRAME_EVERY_PROCESSOR
#endif

namespace ndframe
{

/// Numbers that are worked on side by side. In memory they need not be aligned, so they are loaded and stored: a
/// pointer to such a type promises an alignment, and a typedef without that promise loses it in `auto` and in
/// templates.
typedef double DoubleLanes __attribute__((vector_size(64)));
typedef float FloatLanes __attribute__((vector_size(64)));

/// Reads as many numbers as there are lanes.
template <class Lanes, class Number>
inline __attribute__((always_inline)) void load(const Number* from, Lanes& lanes)
{
  std::memcpy(&lanes, from, sizeof(lanes));
}

/// Writes as many numbers as there are lanes.
template <class Lanes, class Number>
inline __attribute__((always_inline)) void store(const Lanes& lanes, Number* to)
{
  std::memcpy(to, &lanes, sizeof(lanes));
}

} // namespace ndframe
