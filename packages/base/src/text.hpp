#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ndframe
{

/// `text` without the white space at its ends.
std::string_view trimmed(std::string_view text);

/// The parts of `text` between separators, as they stand.
std::vector<std::string> split(std::string_view text, std::string_view separator);

/// Position of the first byte that cannot stand in a deck: a control character other than tab and line end, or a byte
/// that does not belong to well-formed UTF-8.
std::optional<std::size_t> findInvalidByte(std::string_view text);

/// With ASCII's capitals as small letters.
std::string lowered(std::string text);

/// A text as messages quote it: in quotes, and cut when it is long.
std::string inQuotes(std::string_view text);

/// `text` broken at spaces into lines of at most `width` columns, every line after `indent` spaces, each with its line
/// end.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 100);

} // namespace ndframe
