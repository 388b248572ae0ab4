#include "value_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/expression.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

[[noreturn]] void refuse(const std::string& reason)
{
  throw std::invalid_argument(reason);
}

/// from_chars takes no leading plus.
std::string_view withoutPlus(std::string_view text)
{
  return text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+' ? text.substr(1) : text;
}

bool parseBool(std::string_view text)
{
  if (text != "true" && text != "false")
    refuse("is not a bool (true or false)");
  return text == "true";
}

int parseInt(std::string_view text)
{
  const auto digits = withoutPlus(text);
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    refuse("does not fit in an int");
  if (error != std::errc() || end != digits.data() + digits.size())
    refuse("is not an int");
  return value;
}

double parseDouble(std::string_view text)
{
  const auto digits = withoutPlus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    refuse("is too large or too small for a double");
  if (error != std::errc() || end != digits.data() + digits.size())
    refuse("is not a number");
  if (!std::isfinite(value))
    refuse("is not finite");
  return value;
}

std::string parseString(std::string_view text)
{
  return std::string(text);
}

/// "{1, 2, 3}", "{}".
template <class T>
std::vector<T> parseArray(const std::string& text, T (*parseElement)(std::string_view))
{
  auto inner = trimmed(text);
  if (inner.size() < 2 || inner.front() != '{' || inner.back() != '}')
    refuse("is not an array such as {1, 2, 3}");
  inner = trimmed(inner.substr(1, inner.size() - 2));
  std::vector<T> values;
  if (inner.empty())
    return values;
  for (const auto& part : split(inner, ",")) {
    const auto element = trimmed(part);
    if (element.empty() || element.find_first_of("{}") != std::string_view::npos)
      refuse(fmt::format("is not a flat array: its element {} is {}", values.size() + 1, inQuotes(element)));
    try {
      values.push_back(parseElement(element));
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("is wrong in element {}: {} {}", values.size() + 1, element, error.what()));
    }
  }
  return values;
}

/// An expression keeps the text; compiling it tells whether it parses.
std::string parseExpression(const std::string& text)
{
  try {
    Expression expression(text);
  } catch (const std::invalid_argument& error) {
    refuse(fmt::format("is not an expression in x, y, z: {}", error.what()));
  }
  return text;
}

/// All that is known of a kind: what a deck calls it, which other kinds it accepts, how its text is read.
struct KindTraits
{
  Kind kind;
  std::string name;
  std::vector<Kind> alsoAccepts;
  Value (*parse)(const std::string& text);
};

const KindTraits& traits(Kind kind)
{
  static const std::vector<KindTraits> table{
      {Kind::Bool, "bool", {}, [](const std::string& t) -> Value { return parseBool(trimmed(t)); }},
      {Kind::Int, "int", {}, [](const std::string& t) -> Value { return parseInt(trimmed(t)); }},
      {Kind::Double, "double", {Kind::Int}, [](const std::string& t) -> Value { return parseDouble(trimmed(t)); }},
      {Kind::String, "string", {}, [](const std::string& t) -> Value { return t; }},
      {Kind::Expression,
       "expression",
       {Kind::Int, Kind::Double, Kind::String},
       [](const std::string& t) -> Value { return parseExpression(t); }},
      {Kind::Ints, "Array(int)", {}, [](const std::string& t) -> Value { return parseArray<int>(t, parseInt); }},
      {Kind::Doubles,
       "Array(double)",
       {Kind::Ints},
       [](const std::string& t) -> Value { return parseArray<double>(t, parseDouble); }},
      {Kind::Strings,
       "Array(string)",
       {},
       [](const std::string& t) -> Value { return parseArray<std::string>(t, parseString); }},
  };
  const auto found = std::find_if(table.begin(), table.end(), [&](const KindTraits& t) { return t.kind == kind; });
  NDFRAME_ASSERT(found != table.end(), "a kind has no entry in the table of kinds");
  return *found;
}

template <class T>
std::string arrayText(const std::vector<T>& values)
{
  return fmt::format("{{{}}}", fmt::join(values, ", "));
}

} // namespace

const std::string& kindName(Kind kind)
{
  return traits(kind).name;
}

std::optional<Kind> kindFromType(const std::string& type)
{
  for (const Kind kind : {Kind::Bool, Kind::Int, Kind::Double, Kind::String, Kind::Ints, Kind::Doubles, Kind::Strings})
    if (kindName(kind) == type)
      return kind;
  return std::nullopt;
}

bool accepts(Kind wanted, Kind written)
{
  const auto& others = traits(wanted).alsoAccepts;
  return wanted == written || std::find(others.begin(), others.end(), written) != others.end();
}

Value parseValue(Kind kind, const std::string& text)
{
  return traits(kind).parse(text);
}

Kind guessKind(const std::string& text)
{
  for (const Kind kind : {Kind::Bool, Kind::Int, Kind::Double}) {
    try {
      parseValue(kind, text);
      return kind;
    } catch (const std::invalid_argument&) {
      // not this kind; try the next wider one
    }
  }
  return Kind::String;
}

Kind kindOf(const Value& value)
{
  constexpr std::array<Kind, std::variant_size_v<Value>> kinds{Kind::Bool, Kind::Int,     Kind::Double, Kind::String,
                                                               Kind::Ints, Kind::Doubles, Kind::Strings};
  return kinds[value.index()];
}

std::string valueText(const Value& value)
{
  struct Writer
  {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(int v) const { return fmt::format("{}", v); }
    std::string operator()(double v) const { return fmt::format("{}", v); }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const std::vector<int>& v) const { return arrayText(v); }
    std::string operator()(const std::vector<double>& v) const { return arrayText(v); }
    std::string operator()(const std::vector<std::string>& v) const { return arrayText(v); }
  };
  return std::visit(Writer{}, value);
}

} // namespace ndframe
