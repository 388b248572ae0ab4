#include "summary_json.hpp"

// docs/summary.schema.json describes what is written here; tests/report holds the two together.

namespace ndframe
{
namespace
{

Json bracketJson(const NumberBracket& bracket)
{
  return {{"lower", bracket.lower}, {"upper", bracket.upper}};
}

Json driveJson(const DriveSummary& drive)
{
  return {{"cause", drive.cause},
          {"force", bracketJson(drive.force)},
          {"displacement", bracketJson(drive.displacement)},
          {"stiffness", bracketJson(drive.stiffness)}};
}

} // namespace

Json energyJson(const std::optional<EnergySummary>& energy)
{
  if (!energy)
    return nullptr;
  Json json = bracketJson(energy->energy);
  json["relative_width"] = energy->relativeWidth;
  json["certificates"] = energy->certificates;
  json["work"] = energy->work ? bracketJson(*energy->work) : Json();
  json["work_of"] = energy->workOf;
  json["drive"] = energy->drive ? driveJson(*energy->drive) : Json();
  return json;
}

Json bracketOrNull(const std::optional<NumberBracket>& bracket)
{
  return bracket ? bracketJson(*bracket) : Json();
}

} // namespace ndframe
