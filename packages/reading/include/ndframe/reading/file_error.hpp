#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace ndframe
{

/// A mesh file is unreadable or unfit. Its reader adds the names of the file and the deck's place and throws
/// InputError.
class FileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Follows a mesh error when the file holds several bodies and the deck chose none of them; else empty.
std::string choiceHint(const std::vector<std::string>& bodies, const char* key);

} // namespace ndframe
