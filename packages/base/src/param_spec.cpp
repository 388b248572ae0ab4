#include "ndframe/base/param_spec.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/diagnostics.hpp"
#include "value_text.hpp"

namespace ndframe
{

namespace
{

/// A range of numbers; every entry of an array must lie in it.
Range numbers(std::string text, std::function<bool(double)> contains)
{
  const auto test = [contains = std::move(contains)](const Value& value) {
    const auto all = [&](const auto& list) { return std::all_of(list.begin(), list.end(), contains); };
    if (const auto* single = std::get_if<double>(&value))
      return contains(*single);
    if (const auto* single = std::get_if<int>(&value))
      return contains(*single);
    if (const auto* list = std::get_if<std::vector<int>>(&value))
      return all(*list);
    if (const auto* list = std::get_if<std::vector<double>>(&value))
      return all(*list);
    throw InternalError("a range of numbers is given to a parameter that is not a number");
  };
  return {std::move(text), test};
}

/// True when the text of the value reads back to it: finite numbers, strings that an array can hold, right expressions.
bool survivesDeck(Kind kind, const Value& value)
{
  try {
    return parseValue(kind, valueText(value)) == value;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

} // namespace

Range inOpenRange(double low, double high)
{
  return numbers(fmt::format("({}, {})", low, high), [=](double value) { return low < value && value < high; });
}

Range inClosedRange(double low, double high)
{
  return numbers(fmt::format("[{}, {}]", low, high), [=](double value) { return low <= value && value <= high; });
}

Range above(double low)
{
  return numbers(fmt::format("> {}", low), [=](double value) { return value > low; });
}

Range atLeast(double low)
{
  return numbers(fmt::format(">= {}", low), [=](double value) { return value >= low; });
}

Range oneOf(std::vector<std::string> names)
{
  std::string text = fmt::format("{}", fmt::join(names, " | "));
  const auto test = [names = std::move(names)](const Value& value) {
    const auto known = [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (const auto* single = std::get_if<std::string>(&value))
      return known(*single);
    if (const auto* list = std::get_if<std::vector<std::string>>(&value))
      return std::all_of(list->begin(), list->end(), known);
    throw InternalError("a choice of names is given to a parameter that is not a string");
  };
  return {std::move(text), test};
}

ParamSpec::ParamSpec(std::string name_, Kind kind_, bool isRequired_, Range range_, std::string doc_)
    : name(std::move(name_)), kind(kind_), isRequired(isRequired_), range(std::move(range_)), doc(std::move(doc_))
{}

ParamSpec::ParamSpec(std::string name_, Value defaultValue_, Range range_, std::string doc_)
    : ParamSpec(std::move(name_), kindOf(defaultValue_), false, std::move(range_), std::move(doc_))
{
  NDFRAME_ASSERT(!range.contains || range.contains(defaultValue_),
                 "the default of \"" + name + "\" is out of its range");
  NDFRAME_ASSERT(survivesDeck(kind, defaultValue_), "the default of \"" + name + "\" cannot be written in a deck");
  defaultValue = std::move(defaultValue_);
}

ParamSpec::ParamSpec(std::string name_, Value defaultValue_, std::string doc_)
    : ParamSpec(std::move(name_), std::move(defaultValue_), Range{}, std::move(doc_))
{}

ParamSpec ParamSpec::required(std::string name, Kind kind, Range range, std::string doc)
{
  return {std::move(name), kind, true, std::move(range), std::move(doc)};
}

ParamSpec ParamSpec::required(std::string name, Kind kind, std::string doc)
{
  return required(std::move(name), kind, Range{}, std::move(doc));
}

ParamSpec ParamSpec::optional(std::string name, Kind kind, Range range, std::string doc)
{
  return {std::move(name), kind, false, std::move(range), std::move(doc)};
}

ParamSpec ParamSpec::optional(std::string name, Kind kind, std::string doc)
{
  return optional(std::move(name), kind, Range{}, std::move(doc));
}

ParamSpec ParamSpec::expression(std::string name, std::string defaultText, std::string doc)
{
  ParamSpec spec(std::move(name), Kind::Expression, false, Range{}, std::move(doc));
  NDFRAME_ASSERT(survivesDeck(spec.kind, defaultText), "the default of \"" + spec.name + "\" is not an expression");
  spec.defaultValue = std::move(defaultText);
  return spec;
}

void failUnknownName(const std::string& name)
{
  throw InternalError("\"" + name + "\" passed validation but is not in its table of names");
}

} // namespace ndframe
