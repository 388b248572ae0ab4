#include "checked_value.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "ndframe/base/help.hpp"
#include "spec_text.hpp"
#include "text.hpp"
#include "value_text.hpp"

namespace ndframe
{

namespace
{

constexpr const char* nameSeparator = " | ";

std::string wantedType(Kind kind)
{
  return kind == Kind::Expression ? "double or string (an expression in x, y, z)" : kindName(kind);
}

Value parsed(const DeckEntry& entry, Kind kind)
{
  try {
    return parseValue(kind, entry.value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{} = {} {}.", entry.name, inQuotes(entry.value), error.what()));
  }
}

std::string outOfRange(const std::string& name, const Value& value, const Range& range)
{
  const auto* text = std::get_if<std::string>(&value);
  const std::string start = fmt::format("{} = {} ", name, text != nullptr ? inQuotes(*text) : valueText(value));
  if (isInterval(range))
    return start + "is outside " + range.text + ".";
  if (range.text.find(nameSeparator) == std::string::npos)
    return start + "is not valid: it must be " + range.text + ".";
  const std::string near = text != nullptr ? nearestName(*text, split(range.text, nameSeparator)) : "";
  return start + "is not one of " + range.text + (near.empty() ? "." : "; did you mean " + inQuotes(near) + "?");
}

} // namespace

Value checkedValue(const DeckEntry& entry, const ParamSpec& spec)
{
  const auto stated = entry.type.empty() ? spec.kind : kindFromType(entry.type);
  if (!stated)
    throw std::invalid_argument(
        fmt::format("{} has the unknown type {}; write {}.", entry.name, inQuotes(entry.type), wantedType(spec.kind)));
  if (!accepts(spec.kind, *stated))
    throw std::invalid_argument(
        fmt::format("{} is of type {}; it must be {}.", entry.name, entry.type, wantedType(spec.kind)));
  parsed(entry, *stated); // "0.5" is a double, but not one that is stated to be an int
  Value value = parsed(entry, spec.kind);
  if (spec.range.contains && !spec.range.contains(value))
    throw std::invalid_argument(outOfRange(entry.name, value, spec.range));
  return value;
}

Value statedValue(const DeckEntry& entry)
{
  const auto kind = entry.type.empty() ? guessKind(entry.value) : kindFromType(entry.type);
  if (!kind)
    throw std::invalid_argument(fmt::format("{} has the unknown type {}; write bool, int, double, string, Array(int), "
                                            "Array(double) or Array(string).",
                                            entry.name, inQuotes(entry.type)));
  return parsed(entry, *kind);
}

std::string missingMessage(const ParamSpec& spec)
{
  const std::string range = rangeText(spec.range);
  return fmt::format("{} is missing ({}{}).", spec.name, kindText(spec.kind), range.empty() ? "" : ", " + range);
}

} // namespace ndframe
