#include "ndframe/report/found_screen.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ndframe
{

namespace
{

/// Bodies and sides of all, and what `rest` says of each behind them.
template <class Rest>
std::string table(const std::vector<FoundInterface>& found, const std::string& title, const std::string& heads,
                  const Rest& rest)
{
  std::size_t bodies = 4, sides = 4;
  for (const FoundInterface& one : found) {
    bodies = std::max({bodies, one.firstBody.size(), one.secondBody.size()});
    sides = std::max({sides, one.firstSide.size(), one.secondSide.size()});
  }
  const auto line = [&](const auto& a, const auto& b, const auto& c, const auto& d) {
    return fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}} ", a, bodies, b, sides, c, bodies, d, sides);
  };
  std::string text = title + "\n\n" + line("body", "side", "body", "side") + heads;
  for (const FoundInterface& one : found)
    text += "\n" + line(one.firstBody, one.firstSide, one.secondBody, one.secondSide) + rest(one);
  return text;
}

} // namespace

std::string foundText(const std::vector<FoundInterface>& found, double distance)
{
  if (found.empty())
    return fmt::format("  Automatic: no more sides face each other within {:.4g}", distance);
  return table(found, fmt::format("  Automatic: sides that face each other within {:.4g}", distance),
               fmt::format("{:>12} {:>12} {:>12}", "length", "opening from", "to"), [](const FoundInterface& one) {
                 return fmt::format("{:>12.6g} {:>12.3g} {:>12.3g}", one.length, one.smallest, one.largest);
               });
}

std::string matchingText(const std::vector<FoundInterface>& found)
{
  if (found.empty())
    return "  Automatic: no more sides lie on each other";
  return table(found, "  Automatic: sides that lie on each other", fmt::format("{:>12}", "area"),
               [](const FoundInterface& one) { return fmt::format("{:>12.6g}", one.length); });
}

} // namespace ndframe
