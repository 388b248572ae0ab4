#include <gmock/gmock.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/expression.hpp"

using namespace ndframe;
using test::fullDeck;
using test::smallestDeck;
using test::validated;

TEST(Validation, FillsInDefaultsAndKnowsWhatWasGiven)
{
  const Params params = validated(smallestDeck());
  EXPECT_EQ(params.name(), "small");
  EXPECT_EQ(params.path(), "");
  EXPECT_EQ(params.get<std::string>("Pattern"), "Right");
  EXPECT_TRUE(params.has("Pattern"));
  EXPECT_FALSE(params.isGiven("Pattern"));
  EXPECT_EQ(params.get<std::vector<double>>("Grading"), (std::vector<double>{1.0, 1.0}));
  const Params stopping = params.sub("Coupling").sub("Stopping");
  EXPECT_EQ(stopping.path(), "Coupling/Stopping");
  EXPECT_EQ(stopping.get<int>("Maximum Sweeps"), 100);
  const Params material = params.sub("Bodies").sub("punch").sub("Material");
  EXPECT_EQ(material.path(), "Bodies/punch/Material");
  EXPECT_TRUE(material.isGiven("Young Modulus"));
  EXPECT_EQ(material.get<double>("Poisson Ratio"), 0.3);
}

TEST(Validation, GivesEveryKindItsType)
{
  const Params params = validated(fullDeck());
  EXPECT_EQ(params.get<std::string>("Pattern"), "Crossed");
  EXPECT_EQ(params.get<std::vector<std::string>>("Fields"), (std::vector<std::string>{"stress", "gap"}));
  EXPECT_EQ(params.sub("Output").get<bool>("Exodus"), false);
  EXPECT_EQ(params.sub("Coupling").sub("Relaxation").sub("History").get<int>("Depth"), 3);
  EXPECT_EQ(params.expression("Gap")(3, 0, 0), 4.5);
  const Params upper = params.sub("Bodies").sub("upper");
  EXPECT_EQ(upper.get<std::vector<int>>("Cells"), (std::vector<int>{8, 8}));
  EXPECT_EQ(params.sub("Bodies").sub("lower").get<std::vector<std::string>>("Parts").size(), 0U);
}

TEST(Validation, AcceptsIntsWhereDoublesAreWanted)
{
  const Params params = validated(fullDeck());
  EXPECT_EQ(params.get<std::vector<double>>("Grading"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(params.sub("Bodies").sub("upper").get<double>("Thickness"), 2.0);
}

TEST(Validation, AcceptsANumberWhereAnExpressionIsWanted)
{
  const auto gap = [](const std::string& type, const std::string& value) {
    std::string deck = fullDeck();
    const std::string old = R"(type="string" value="0.5*x^2")";
    deck.replace(deck.find(old), old.size(), "type=\"" + type + "\" value=\"" + value + "\"");
    return validated(deck).expression("Gap");
  };
  EXPECT_EQ(gap("double", "1e-3")(0, 0, 0), 1e-3);
  EXPECT_EQ(gap("int", "2")(0, 0, 0), 2.0);
  EXPECT_TRUE(gap("double", "0.25").isConstant());
}

TEST(Validation, LeavesOutWhatIsOptionalAndNotGiven)
{
  const Params params = validated(smallestDeck());
  EXPECT_FALSE(params.hasSub("Output"));
  EXPECT_FALSE(params.sub("Bodies").sub("punch").has("Thickness"));
  EXPECT_TRUE(params.hasSub("Library"));
  EXPECT_TRUE(validated(fullDeck()).hasSub("Output"));
}

TEST(Validation, KeepsUserNamedListsInTheOrderOfTheDeck)
{
  const auto bodies = validated(fullDeck()).sub("Bodies").subs();
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].name(), "upper");
  EXPECT_EQ(bodies[1].name(), "lower");
}

TEST(Validation, TakesTheKeysOfTheChosenComponentOnly)
{
  const Params constant = validated(smallestDeck()).sub("Coupling").sub("Relaxation");
  EXPECT_EQ(constant.get<std::string>("Type"), "Constant");
  EXPECT_TRUE(constant.has("Theta"));
  EXPECT_FALSE(constant.has("Initial Theta"));
  EXPECT_FALSE(constant.hasSub("History"));
  const Params aitken = validated(fullDeck()).sub("Coupling").sub("Relaxation");
  EXPECT_TRUE(aitken.has("Initial Theta"));
  EXPECT_FALSE(aitken.has("Theta"));
}

TEST(Validation, HandsPassThroughListsOnAsWritten)
{
  EXPECT_EQ(validated(fullDeck()).sub("Library").get<int>("level"), 2);
}

TEST(Validation, PlacesLaterMistakesAtTheirKeyOrTheirList)
{
  const Params material = validated(smallestDeck()).sub("Bodies").sub("punch").sub("Material");
  EXPECT_EQ(material.mistake("Young Modulus", "is odd.").text(), "deck.xml:6: Bodies/punch/Material: is odd.");
  EXPECT_EQ(material.mistake("Poisson Ratio", "is odd.").text(), "deck.xml:4: Bodies/punch/Material: is odd.");
  EXPECT_EQ(material.mistake("", "is odd.").text(), "deck.xml:4: Bodies/punch/Material: is odd.");
  // A list that the user did not write has the place of the list around it.
  EXPECT_EQ(validated(smallestDeck()).sub("Coupling").mistake("", "is odd.").text(), "deck.xml:1: Coupling: is odd.");
}

TEST(Validation, CallsProgrammersMistakesBugs)
{
  const Params params = validated(smallestDeck());
  EXPECT_THROW(params.get<int>("No Such Key"), InternalError);
  EXPECT_THROW(params.get<int>("Pattern"), InternalError);
  EXPECT_THROW(params.sub("No Such List"), InternalError);
  EXPECT_THROW(params.sub("Output"), InternalError);
  EXPECT_THROW(params.expression("Title"), InternalError);
}

namespace
{

/// A deck of user-named parameters, each a text, beside one with a name of its own.
ListSpec namedTexts()
{
  ListSpec spec;
  spec.name = "deck";
  spec.params = {ParamSpec("Known", 1, "A number.")};
  spec.eachParam = ParamSpec::required("PATH", Kind::String, "A text.");
  return spec;
}

} // namespace

TEST(Validation, TakesNamedParametersOfOneKind)
{
  const Params params = validated(R"(<ParameterList name="deck">
    <Parameter name="Known" type="int" value="2"/>
    <Parameter name="Coupling/Theta" type="string" value="0.5; 0.6"/>
    <Parameter name="Cells" type="string" value="{4, 4}; {8, 8}"/>
  </ParameterList>)",
                                  namedTexts());
  EXPECT_EQ(params.get<int>("Known"), 2);
  EXPECT_EQ(params.get<std::string>("Coupling/Theta"), "0.5; 0.6");
  EXPECT_EQ(params.get<std::string>("Cells"), "{4, 4}; {8, 8}");
}

TEST(Validation, RefusesNamedParametersOfAnotherKind)
{
  const std::string deck = R"(<ParameterList name="deck">
    <Parameter name="Theta" type="double" value="0.5"/>
  </ParameterList>)";
  EXPECT_THROW(validated(deck, namedTexts()), InputError);
}

TEST(Validation, RefusesPathsWhereNoParametersAreNamed)
{
  std::string deck = smallestDeck();
  deck.replace(deck.find("\"Young Modulus\""), 15, "\"Young/Modulus\"");
  EXPECT_THROW(validated(deck), InputError);
}
