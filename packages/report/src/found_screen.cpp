#include "ndframe/report/found_screen.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ndframe
{

std::string foundText(const std::vector<FoundInterface>& found, double distance)
{
  if (found.empty())
    return fmt::format("  Automatic: no more sides face each other within {:.4g}", distance);
  std::size_t bodies = 4, sides = 4;
  for (const FoundInterface& one : found) {
    bodies = std::max({bodies, one.firstBody.size(), one.secondBody.size()});
    sides = std::max({sides, one.firstSide.size(), one.secondSide.size()});
  }
  std::string text = fmt::format("  Automatic: sides that face each other within {:.4g}\n\n", distance);
  text += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}} {:>12} {:>12} {:>12}", "body", bodies, "side", sides, "body",
                      bodies, "side", sides, "length", "opening from", "to");
  for (const FoundInterface& one : found)
    text += fmt::format("\n  {:<{}}  {:<{}}  {:<{}}  {:<{}} {:>12.6g} {:>12.3g} {:>12.3g}", one.firstBody, bodies,
                        one.firstSide, sides, one.secondBody, bodies, one.secondSide, sides, one.length, one.smallest,
                        one.largest);
  return text;
}

} // namespace ndframe
