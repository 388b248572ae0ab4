#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

#include "ndframe/base/expression.hpp"

using ndframe::Expression;
using testing::HasSubstr;

namespace
{

std::string refusal(const std::string& text)
{
  try {
    const Expression expression(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Expression, EvaluatesInThePosition)
{
  const Expression field("sin(pi*x) + y^2 - z/4 + max(x, y)");
  for (const double s : {-1.5, 0.0, 0.3, 2.0})
    EXPECT_DOUBLE_EQ(field(s, 2 * s, 3 * s), std::sin(M_PI * s) + 4 * s * s - 0.75 * s + std::max(s, 2 * s));
}

TEST(Expression, KnowsConditions)
{
  const Expression step("x <= 0.5 && y >= 0 ? -1 : 2");
  EXPECT_EQ(step(0.5, 0, 0), -1);
  EXPECT_EQ(step(0.6, 0, 0), 2);
}

TEST(Expression, KeepsItsTextAndTellsWhetherItIsConstant)
{
  EXPECT_EQ(Expression("2 * pi").text(), "2 * pi");
  EXPECT_TRUE(Expression("2 * pi").isConstant());
  EXPECT_TRUE(Expression("-1e-3").isConstant());
  EXPECT_FALSE(Expression("x").isConstant());
  EXPECT_FALSE(Expression("exp(1) + 0*z").isConstant());
}

TEST(Expression, CopiesDoNotDisturbEachOther)
{
  const Expression original("x + 10*y");
  const Expression copy = original;
  EXPECT_EQ(original(1, 2, 0), 21);
  EXPECT_EQ(copy(3, 4, 0), 43);
  EXPECT_EQ(original(1, 2, 0), 21);
}

TEST(Expression, LeavesNonFiniteValuesToTheCaller)
{
  EXPECT_TRUE(std::isinf(Expression("1/x")(0, 0, 0)));
  EXPECT_TRUE(std::isnan(Expression("sqrt(x)")(-1, 0, 0)));
}

TEST(Expression, NamesWhatItDoesNotKnowAndWhatItDoes)
{
  EXPECT_THAT(refusal("2*radius"),
              HasSubstr("\"radius\" at character 3 is unknown; an expression may use x, y, z, pi"));
  EXPECT_THAT(refusal("t"), HasSubstr("\"t\" at character 1 is unknown"));
  EXPECT_THAT(refusal("_e"), HasSubstr("\"_e\" at character 1 is unknown"));
}

TEST(Expression, ThatDoesNotParseIsRefusedWithThePosition)
{
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("2*"), HasSubstr("Unexpected end of expression at position"));
  EXPECT_THAT(refusal("(x"), HasSubstr("parenthesis"));
  EXPECT_THAT(refusal("2 x"), HasSubstr("position 2"));
  EXPECT_THAT(refusal("sin(x, y)"), HasSubstr("Too many parameters"));
}

TEST(Expression, MustBeOneNumberAndMustNotAssign)
{
  EXPECT_THAT(refusal("0,5"), HasSubstr("write a decimal point, not a comma"));
  EXPECT_THAT(refusal("x = 3"), HasSubstr("\"=\" at character 3 would assign"));
  EXPECT_THAT(refusal("(y=2)+x"), HasSubstr("would assign"));
  EXPECT_EQ(Expression("x == 3")(3, 0, 0), 1);
  EXPECT_EQ(Expression("x != 3")(3, 0, 0), 0);
}
