#include "ndframe/base/expression.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <muParser.h>

#include "ndframe/base/expression_tree.hpp"
#include "text.hpp"

namespace ndframe
{

/// muParser checks the text and says what is wrong with it; the values are those of the tree.
struct Expression::Parser
{
  ExpressionTree tree;
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

/// Throws with muParser's reason unless `text` is one number.
void checkSyntax(const std::string& text)
{
  double position[3] = {};
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", 3.14159265358979323846);
  parser.DefineVar("x", position);
  parser.DefineVar("y", position + 1);
  parser.DefineVar("z", position + 2);
  try {
    parser.SetExpr(text);
    parser.Eval();
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(reason(error));
  }
  if (parser.GetNumResults() != 1)
    throw std::invalid_argument("it has several results separated by commas; write a decimal point, not a comma");
}

} // namespace

Expression::Expression(const std::string& text) : text_(text)
{
  refuseAssignment(text);
  checkSyntax(text);
  parser_ = std::make_shared<Parser>(Parser{ExpressionTree(text)});
}

double Expression::operator()(double x, double y, double z) const
{
  const double point[3] = {x, y, z};
  double value = 0.0;
  parser_->tree.values(point, 1, &value);
  return value;
}

bool Expression::isConstant() const
{
  return parser_->tree.isConstant();
}

} // namespace ndframe
