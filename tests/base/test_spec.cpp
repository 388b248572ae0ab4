#include <limits>

#include <gtest/gtest.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/param_spec.hpp"

using namespace ndframe;

TEST(Range, OfNumbersHoldsItsEndsOrNot)
{
  EXPECT_EQ(inOpenRange(0, 2).text, "(0, 2)");
  EXPECT_FALSE(inOpenRange(0, 2).contains(0.0));
  EXPECT_TRUE(inOpenRange(0, 2).contains(1));
  EXPECT_FALSE(inOpenRange(0, 2).contains(2.0));
  EXPECT_EQ(inClosedRange(-1, 0.5).text, "[-1, 0.5]");
  EXPECT_TRUE(inClosedRange(-1, 0.5).contains(0.5));
  EXPECT_TRUE(inClosedRange(-1, 0.5).contains(-1));
  EXPECT_FALSE(inClosedRange(-1, 0.5).contains(0.6));
  EXPECT_EQ(above(0).text, "> 0");
  EXPECT_FALSE(above(0).contains(0));
  EXPECT_EQ(atLeast(1).text, ">= 1");
  EXPECT_TRUE(atLeast(1).contains(1));
}

TEST(Range, OfAnArrayHoldsForEveryEntry)
{
  EXPECT_TRUE(above(0).contains(std::vector<double>{1.0, 2.0}));
  EXPECT_FALSE(above(0).contains(std::vector<int>{1, 0}));
  EXPECT_TRUE(oneOf({"a", "b"}).contains(std::vector<std::string>{"a", "b", "a"}));
  EXPECT_FALSE(oneOf({"a", "b"}).contains(std::vector<std::string>{"a", "c"}));
}

TEST(Range, GivenToTheWrongKindIsABug)
{
  EXPECT_THROW(above(0).contains(std::string("a")), InternalError);
  EXPECT_THROW(oneOf({"a"}).contains(1), InternalError);
}

TEST(ParamSpec, TakesItsKindFromItsDefault)
{
  EXPECT_EQ(ParamSpec("a", true, "").kind, Kind::Bool);
  EXPECT_EQ(ParamSpec("a", 1, "").kind, Kind::Int);
  EXPECT_EQ(ParamSpec("a", 1.0, "").kind, Kind::Double);
  EXPECT_EQ(ParamSpec("a", "text", "").kind, Kind::String);
  EXPECT_EQ(ParamSpec("a", std::vector<int>{}, "").kind, Kind::Ints);
  EXPECT_EQ(ParamSpec("a", std::vector<double>{}, "").kind, Kind::Doubles);
  EXPECT_EQ(ParamSpec("a", std::vector<std::string>{}, "").kind, Kind::Strings);
  EXPECT_EQ(ParamSpec::expression("a", "x", "").kind, Kind::Expression);
}

TEST(ParamSpec, RefusesDefaultsThatNoDeckCouldHold)
{
  EXPECT_THROW(ParamSpec("a", 3.0, inOpenRange(0, 2), ""), InternalError);
  EXPECT_THROW(ParamSpec("a", "Rihgt", oneOf({"Right"}), ""), InternalError);
  EXPECT_THROW(ParamSpec("a", std::vector<std::string>{"a, b"}, ""), InternalError);
  EXPECT_THROW(ParamSpec("a", std::numeric_limits<double>::infinity(), ""), InternalError);
  EXPECT_THROW(ParamSpec::expression("a", "2*", ""), InternalError);
}

TEST(Names, ConvertBothWaysAndGiveTheRange)
{
  enum class Colour
  {
    Red,
    Green
  };
  const Names<Colour> names{{"red", Colour::Red}, {"green", Colour::Green}};
  EXPECT_EQ(names.range().text, "red | green");
  EXPECT_EQ(names.value("green"), Colour::Green);
  EXPECT_EQ(names.name(Colour::Red), "red");
  EXPECT_THROW(names.value("blue"), InternalError);
}

TEST(Diagnostic, SaysFileLinePathAndMessage)
{
  EXPECT_EQ((Diagnostic{"d.xml", 4, "A/B", "is odd."}.text()), "d.xml:4: A/B: is odd.");
  EXPECT_EQ((Diagnostic{"d.xml", 0, "", "is odd."}.text()), "d.xml: is odd.");
  EXPECT_EQ((Diagnostic{"", 0, "A", "is odd."}.text()), "A: is odd.");
  EXPECT_STREQ(InputError("is odd.").what(), "is odd.");
}

TEST(Diagnostics, ThrowAllMistakesAtOnce)
{
  Diagnostics some;
  EXPECT_NO_THROW(some.throwIfAny());
  some.add({"d.xml", 1, "", "one."});
  Diagnostics more;
  more.add({"d.xml", 2, "", "two."});
  some.append(more);
  try {
    some.throwIfAny();
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "d.xml:1: one.\nd.xml:2: two.");
    EXPECT_EQ(error.list().size(), 2U);
  }
}

TEST(Assertion, CarriesItsPlaceAndCondition)
{
  try {
    NDFRAME_ASSERT(1 > 2, "numbers are broken");
    FAIL() << "nothing was thrown";
  } catch (const InternalError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("test_spec.cpp:"), std::string::npos) << what;
    EXPECT_NE(what.find("numbers are broken (1 > 2 does not hold)"), std::string::npos) << what;
  }
}
