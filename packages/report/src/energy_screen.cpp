#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/report/error_screen.hpp"

namespace ndframe
{
namespace
{

/// Both ends with the digits that tell them apart.
std::string text(NumberBracket bracket)
{
  const double size = std::max(std::abs(bracket.lower), std::abs(bracket.upper));
  const double relative = size > 0.0 ? (bracket.upper - bracket.lower) / size : 0.0;
  const int digits = relative > 0.0 ? int(std::clamp(std::ceil(-std::log10(relative)) + 2.0, 4.0, 15.0)) : 15;
  return fmt::format("[{:.{}g}, {:.{}g}]", bracket.lower, digits, bracket.upper, digits);
}

std::string line(const std::string& what, NumberBracket bracket, const std::string& remark)
{
  return fmt::format("  {:<18}in {}   {}", what, text(bracket), remark);
}

} // namespace

std::string energyText(const EnergySummary& summary)
{
  std::string lines =
      line("energy", summary.energy,
           fmt::format("strain energy less work of the loads, exact, guaranteed; width {:.2g}, {} "
                       "certificate{}",
                       summary.relativeWidth, summary.certificates, summary.certificates == 1 ? "" : "s"));
  if (summary.work)
    lines += "\n" + line("work", *summary.work, "of " + summary.workOf);
  if (const auto& drive = summary.drive) {
    const bool isLoad = drive->force.lower == drive->force.upper;
    lines += "\n" + (isLoad ? line("displacement", drive->displacement, "mean, along " + drive->cause)
                            : line("force", drive->force, "along " + drive->cause));
    lines += "\n" + line("stiffness", drive->stiffness, "force over displacement");
  }
  return lines;
}

} // namespace ndframe
