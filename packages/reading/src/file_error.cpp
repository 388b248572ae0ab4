#include "ndframe/reading/file_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{

std::string choiceHint(const std::vector<std::string>& bodies, const char* key)
{
  return bodies.size() < 2
             ? ""
             : fmt::format(" The file holds {}: choose the body's with {}.", fmt::join(bodies, ", "), key);
}

} // namespace ndframe
