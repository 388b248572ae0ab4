#pragma once

#include <string>

namespace ndframe
{

/// A text as a field of a CSV file: in quotes, as in RFC 4180, when it holds a separator.
std::string csvField(const std::string& text);

} // namespace ndframe
