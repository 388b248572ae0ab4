#pragma once

#include <stdexcept>
#include <string>

namespace ndframe
{

/// A mesh file is unreadable or unfit. Its reader adds the names of the file and the deck's place and throws
/// InputError.
class FileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace ndframe
