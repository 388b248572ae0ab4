#pragma once

#include "ndframe/accuracy/checkpoint.hpp"

namespace ndframe
{

/// CBOR (RFC 8949) of an object with the names above, all numbers bit by bit.
std::string toBytes(const Checkpoint& checkpoint);

/// The same back. Throws InputError: `path` is no checkpoint or ends too early, or another version wrote it (`version`:
/// this one).
Checkpoint checkpointFromBytes(const std::string& bytes, const std::string& path, const std::string& version);

} // namespace ndframe
