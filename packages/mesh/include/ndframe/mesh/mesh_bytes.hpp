#pragma once

#include <string>
#include <string_view>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A mesh as bytes for another process of this machine's kind, bit by bit the same when read back.
std::string toBytes(const Mesh& mesh);

/// Reads what toBytes has made; anything else is a bug (InternalError).
Mesh meshFromBytes(std::string_view bytes);

} // namespace ndframe
