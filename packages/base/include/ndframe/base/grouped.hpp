#pragma once

#include <cstdint>
#include <string>

namespace ndframe
{

/// 12345678 -> "12 345 678".
std::string grouped(std::int64_t number);

} // namespace ndframe
