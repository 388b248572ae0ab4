#include "ndframe/base/expression.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <muParser.h>

#include "text.hpp"

namespace ndframe
{

struct Expression::Parser
{
  mu::Parser parser;
  double x = 0.0, y = 0.0, z = 0.0; ///< muParser reads the variables from here
  bool isConstant = false;
  double constant = 0.0; ///< its value: parsed expressions are slow
};

namespace
{

/// muParser lets an expression assign to its variables; a field must not change the position.
void refuseAssignment(const std::string& text)
{
  const auto isOneOf = [&](std::size_t at, const char* set) {
    return at < text.size() && std::string_view(set).find(text[at]) != std::string_view::npos;
  };
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1))
    if (!isOneOf(at - 1, "<>!=") && !isOneOf(at + 1, "="))
      throw std::invalid_argument(fmt::format("\"=\" at character {} would assign; equality is \"==\"", at + 1));
}

std::string reason(const mu::ParserError& error)
{
  if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN)
    return error.GetMsg();
  return fmt::format(
      "{} at character {} is unknown; an expression may use x, y, z, pi and functions such as sin, sqrt, "
      "exp, abs, min, max",
      inQuotes(trimmed(error.GetToken())), error.GetPos() + 1);
}

} // namespace

Expression::Expression(const std::string& text) : text_(text), parser_(std::make_shared<Parser>())
{
  refuseAssignment(text);
  mu::Parser& parser = parser_->parser;
  parser.ClearConst();
  parser.DefineConst("pi", 3.14159265358979323846);
  parser.DefineVar("x", &parser_->x);
  parser.DefineVar("y", &parser_->y);
  parser.DefineVar("z", &parser_->z);
  try {
    parser.SetExpr(text);
    parser_->constant = parser.Eval();
    parser_->isConstant = parser.GetUsedVar().empty();
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(reason(error));
  }
  if (parser.GetNumResults() != 1)
    throw std::invalid_argument("it has several results separated by commas; write a decimal point, not a comma");
}

double Expression::operator()(double x, double y, double z) const
{
  if (parser_->isConstant)
    return parser_->constant;
  parser_->x = x;
  parser_->y = y;
  parser_->z = z;
  return parser_->parser.Eval();
}

bool Expression::isConstant() const
{
  return parser_->isConstant;
}

} // namespace ndframe
