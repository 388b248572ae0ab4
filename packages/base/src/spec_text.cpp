#include "spec_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "value_text.hpp"

namespace ndframe
{

std::vector<std::string> paramFacts(const ParamSpec& param)
{
  std::vector<std::string> facts{kindText(param.kind),
                                 param.defaultValue ? "default " + defaultText(param) : defaultText(param)};
  if (!param.range.text.empty())
    facts.push_back(rangeText(param.range));
  return facts;
}

std::string presence(const ListSpec& list)
{
  if (list.isRequired && !list.requiredUnless.empty())
    return fmt::format("required unless {} is given", fmt::join(list.requiredUnless, " or "));
  return list.isRequired ? "required" : list.onlyIfGiven ? "only if given" : "optional";
}

std::string kindText(Kind kind)
{
  return kind == Kind::Expression ? "number or expression in x, y, z" : kindName(kind);
}

std::string defaultText(const ParamSpec& param)
{
  if (!param.defaultValue)
    return param.isRequired ? "required" : "optional";
  const std::string text = valueText(*param.defaultValue);
  return text.empty() ? "\"\"" : text;
}

bool isInterval(const Range& range)
{
  return !range.text.empty() && (range.text[0] == '(' || range.text[0] == '[');
}

std::string rangeText(const Range& range)
{
  return isInterval(range) ? "in " + range.text : range.text;
}

} // namespace ndframe
