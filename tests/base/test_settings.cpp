#include <gmock/gmock.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/base/expression.hpp"

using namespace ndframe;

namespace
{

/// The smallest deck with one setting on top.
Params withSetting(const std::string& setting)
{
  DeckList deck = parseDeck(test::smallestDeck(), "deck.xml");
  Diagnostics diagnostics;
  applySetting(deck, setting, diagnostics);
  const Params params = validate(deck, test::sampleSpec(), diagnostics);
  diagnostics.throwIfAny();
  return params;
}

std::string settingComplaint(const std::string& setting)
{
  try {
    withSetting(setting);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Setting, AddsAKeyAndItsListsAndTakesTheTypeOfTheSpec)
{
  const Params params = withSetting("Coupling/Stopping/Tolerance=1e-4");
  EXPECT_EQ(params.sub("Coupling").sub("Stopping").get<double>("Tolerance"), 1e-4);
  EXPECT_TRUE(params.sub("Coupling").sub("Stopping").isGiven("Tolerance"));
}

TEST(Setting, ReplacesWhatTheDeckSays)
{
  const Params params = withSetting("Bodies/punch/Material/Young Modulus=7");
  EXPECT_EQ(params.sub("Bodies").sub("punch").sub("Material").get<double>("Young Modulus"), 7.0);
}

TEST(Setting, MayHoldEqualsAndSlashInItsValue)
{
  EXPECT_EQ(withSetting("Title=a=b/c").get<std::string>("Title"), "a=b/c");
  EXPECT_EQ(withSetting("Gap=x/2").expression("Gap")(3, 0, 0), 1.5);
}

TEST(Setting, SetsArrays)
{
  EXPECT_EQ(withSetting("Grading={1, 2.5}").get<std::vector<double>>("Grading"), (std::vector<double>{1.0, 2.5}));
}

TEST(Setting, OfAListForALibraryIsTypedByItsLook)
{
  const auto level = [](const std::string& value) { return withSetting("Library/level=" + value).sub("Library"); };
  EXPECT_EQ(level("3").get<int>("level"), 3);
  EXPECT_EQ(level("3.5").get<double>("level"), 3.5);
  EXPECT_EQ(level("true").get<bool>("level"), true);
  EXPECT_EQ(level("three").get<std::string>("level"), "three");
}

TEST(Setting, OfTheOuterListNeedsNoSlash)
{
  EXPECT_EQ(withSetting("Pattern=Crossed").get<std::string>("Pattern"), "Crossed");
}

TEST(Setting, ThatIsWrongIsReportedLikeTheDeckWithItsOrigin)
{
  EXPECT_EQ(settingComplaint("Coupling/Stopping/Tolerance=-1"),
            "--set: Coupling/Stopping: Tolerance = -1 is not valid: it must be > 0.");
  EXPECT_EQ(settingComplaint("Coupling/Stopping/Maximum Sweeps=1.5"),
            "--set: Coupling/Stopping: Maximum Sweeps = \"1.5\" is not an int.");
  EXPECT_EQ(settingComplaint("Coupling/Stoping/Tolerance=1"),
            "--set: Coupling: \"Stoping\" is not a list here; did you mean \"Stopping\"?");
  EXPECT_EQ(settingComplaint("Patern=Right"), "--set: \"Patern\" is not a parameter here; did you mean \"Pattern\"?");
}

TEST(Setting, ThatDoesNotParseIsReported)
{
  const std::string advice = "; write \"List/Sublist/Key=value\".";
  EXPECT_EQ(settingComplaint("Title"), "--set: \"Title\" has no \"=\"" + advice);
  EXPECT_EQ(settingComplaint("=1"), "--set: \"=1\" has an empty name before the \"=\"" + advice);
  EXPECT_EQ(settingComplaint("Coupling//Tolerance=1"),
            "--set: \"Coupling//Tolerance=1\" has an empty name before the \"=\"" + advice);
  EXPECT_EQ(settingComplaint("Title=\x01"), "--set: \"Title=\x01\" is not plain UTF-8 text" + advice);
}

TEST(Setting, NestedBeyondReasonIsRefusedRatherThanOverflowingTheStack)
{
  std::string path;
  for (int i = 0; i < 50000; ++i)
    path += "a/";
  EXPECT_THAT(settingComplaint(path + "b=1"), testing::HasSubstr("is nested too deeply"));
}
