#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/help.hpp"

using namespace ndframe;
using test::sampleSpec;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

TEST(Help, OfTheDeckShowsItsParametersAndLists)
{
  const std::string text = helpText(sampleSpec(), "");
  EXPECT_THAT(text, HasSubstr("A deck for the tests."));
  EXPECT_THAT(
      text,
      HasSubstr("    Pattern  (string, default Right, Right | Alternating | Crossed)\n      How squares are cut.\n"));
  EXPECT_THAT(text, HasSubstr("    Gap  (number or expression in x, y, z, default 0)\n"));
  EXPECT_THAT(text, HasSubstr("    Bodies/  (required)\n      The bodies by name.\n"));
  EXPECT_THAT(text, HasSubstr("    Output/  (only if given)\n"));
}

TEST(Help, FindsAListByPathByNameAndByAUsersName)
{
  const std::string stopping = helpText(sampleSpec(), "Coupling/Stopping");
  EXPECT_THAT(stopping, HasSubstr("Coupling/Stopping\n  When the sweeps end.\n"));
  EXPECT_THAT(stopping, HasSubstr("Tolerance  (double, default 0.001, > 0)"));
  EXPECT_EQ(helpText(sampleSpec(), "Stopping"), stopping);
  EXPECT_EQ(helpText(sampleSpec(), "Bodies/punch/Material"), helpText(sampleSpec(), "Material"));
}

TEST(Help, OfAListShowsItsComponents)
{
  const std::string text = helpText(sampleSpec(), "Relaxation");
  EXPECT_THAT(text, HasSubstr("    Type  (string, default Constant, Constant | Aitken)"));
  EXPECT_THAT(text,
              HasSubstr("    Constant\n      A fixed factor.\n        Theta  (double, default 0.5, in (0, 2))\n"));
  EXPECT_THAT(text, HasSubstr("        History/  (optional)\n"));
}

TEST(Help, FindsAComponent)
{
  const std::string text = helpText(sampleSpec(), "Aitken");
  EXPECT_THAT(text, HasSubstr("Coupling/Relaxation, Type = Aitken\n  From the last two residuals.\n"));
  EXPECT_THAT(text, HasSubstr("Initial Theta"));
  EXPECT_THAT(text, Not(HasSubstr("Constant")));
}

TEST(Help, AnswersUnknownNamesWithTheNearest)
{
  for (const auto& [word, nearest] : {std::pair("Relaxtion", "Relaxation"), {"frction", "friction"}})
    EXPECT_THAT([word = word] { helpText(sampleSpec(), word); },
                ThrowsMessage<InputError>(
                    fmt::format("there is no list or component \"{}\"; did you mean \"{}\"?", word, nearest)));
  EXPECT_THROW(helpText(sampleSpec(), "quite another thing"), InputError);
}

TEST(Help, TakesNamesInAnyCaseAndNumber)
{
  const std::string relaxation = helpText(sampleSpec(), "Relaxation");
  for (const char* name : {"relaxation", "RELAXATIONS", "coupling/relaxation"})
    EXPECT_EQ(helpText(sampleSpec(), name), relaxation) << name;
  EXPECT_THAT(helpText(sampleSpec(), "bodies"), testing::StartsWith(helpText(sampleSpec(), "Bodies")));
}

TEST(Help, FindsParametersAndWordsOfTheDocumentation)
{
  const std::string theta = helpText(sampleSpec(), "theta");
  EXPECT_THAT(theta, HasSubstr("Coupling/Relaxation, Type = Constant: Theta"));
  EXPECT_THAT(theta, HasSubstr("Coupling/Relaxation, Type = Aitken: Initial Theta"));
  EXPECT_THAT(helpText(sampleSpec(), "initial theta"), Not(HasSubstr("Constant")));
  EXPECT_THAT(helpText(sampleSpec(), "residuals last"), HasSubstr("Coupling/Relaxation: Type = Aitken"));
}

TEST(Help, KnowsWhatIsNotInThisVersion)
{
  for (const char* word : {"friction", "Friction", "Friction Coefficient", "Time Steps"})
    EXPECT_THAT(limitOf(word), HasSubstr("not in this version; nearest: ")) << word;
  for (const char* word : {"", "Theta", "frictionless", "Time"})
    EXPECT_EQ(limitOf(word), "") << word;
}

TEST(Help, KeepsToAHundredColumns)
{
  ListSpec spec;
  for (int i = 0; i < 60; ++i)
    spec.doc += "many words " + std::to_string(i) + " ";
  std::istringstream lines(helpText(spec, ""));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_LE(line.size(), 100U);
  EXPECT_GT(count, 8);
}

TEST(ComponentList, NamesAllComponentsByTheirLists)
{
  EXPECT_EQ(componentList(sampleSpec()), "Bodies/*/Material\n"
                                         "  Isotropic    Two constants.\n"
                                         "  Orthotropic  Three axes.\n"
                                         "\n"
                                         "Coupling/Relaxation\n"
                                         "  Constant  A fixed factor. (default)\n"
                                         "  Aitken    From the last two residuals.\n");
}

TEST(Reference, HasASectionPerListAndComponentAndARowPerParameter)
{
  const std::string text = referenceMarkdown(sampleSpec());
  EXPECT_THAT(text, HasSubstr("# Deck reference\n\n"));
  EXPECT_THAT(text, HasSubstr("\n## `Coupling/Stopping`\n\nWhen the sweeps end.\n\n| Parameter |"));
  EXPECT_THAT(text,
              HasSubstr("| `Pattern` | string | Right | Right \\| Alternating \\| Crossed | How squares are cut. |\n"));
  EXPECT_THAT(text, HasSubstr("\n### `Coupling/Relaxation`, `Type` = `Aitken`\n"));
  EXPECT_THAT(text, HasSubstr("\n## `Coupling/Relaxation/History` (of `Aitken`)\n"));
  EXPECT_THAT(text, HasSubstr("| On eps\\_tau. |"));
  EXPECT_EQ(text, referenceMarkdown(sampleSpec()));
  EXPECT_EQ(text.back(), '\n');
  EXPECT_THAT(text, Not(HasSubstr("\n\n\n")));
}

TEST(NearestName, FindsMisspellingsAndNothingElse)
{
  const std::vector<std::string> names{"Young Modulus", "Poisson Ratio", "Type", "Order"};
  EXPECT_EQ(nearestName("Poisons Ratio", names), "Poisson Ratio");
  EXPECT_EQ(nearestName("young modulus", names), "Young Modulus");
  EXPECT_EQ(nearestName("Tpye", names), "Type");
  EXPECT_EQ(nearestName("Odre", names), "Order");
  EXPECT_EQ(nearestName("Density", names), "");
  EXPECT_EQ(nearestName("", names), "");
  EXPECT_EQ(nearestName("Type", {}), "");
  EXPECT_EQ(nearestName(std::string(100000, 'x'), names), "");
}
