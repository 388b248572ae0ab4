#include "ndframe/base/grouped.hpp"

namespace ndframe
{

std::string grouped(std::int64_t number)
{
  std::string digits = std::to_string(number);
  for (int at = int(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(std::size_t(at), " ");
  return digits;
}

} // namespace ndframe
