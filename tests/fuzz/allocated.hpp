#pragma once

#include <cstddef>

namespace ndframe::test
{

/// Bytes that `new` has given out and `delete` has not taken back; this program counts them.
std::size_t allocatedBytes();

/// The largest number since the last call.
std::size_t takePeakBytes();

} // namespace ndframe::test
