// What a run with a target leaves behind: files, summary, screen, exit codes, refusals.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "driver/program_folder.hpp"

namespace ndframe::test
{
namespace
{

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Runs of the punch with a target that a few levels reach.
class RunWithATarget : public ProgramFolder
{
protected:
  ProgramResult reach(std::vector<std::string> settings = {}) const
  {
    settings.insert(settings.begin(), "Accuracy/Target=0.05");
    return callDeck("punch", settings);
  }

  std::vector<std::vector<std::string>> table() const
  {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(contentsOf(path("punch.levels.csv")));
    for (std::string line; std::getline(text, line);) {
      rows.emplace_back();
      std::istringstream fields(line + ",");
      for (std::string field; std::getline(fields, field, ',');)
        rows.back().push_back(field);
    }
    return rows;
  }
};

TEST_F(RunWithATarget, SaysInItsSummaryHowItWasReached)
{
  const auto result = reach();
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = summary("punch");
  const auto& accuracy = json["accuracy"];
  EXPECT_TRUE(accuracy["reached"]);
  EXPECT_EQ(accuracy["limit"], "");
  EXPECT_EQ(accuracy["number_of_levels"], accuracy["levels"].size());
  std::int64_t dofs = 0, sweeps = 0;
  for (const auto& level : accuracy["levels"]) {
    dofs += level["dofs"].get<std::int64_t>();
    sweeps += level["sweeps"].get<std::int64_t>();
  }
  EXPECT_EQ(accuracy["total_dofs"], dofs);
  EXPECT_EQ(accuracy["sweeps"], sweeps);
  const auto& last = accuracy["levels"].back();
  EXPECT_EQ(last["bound"], json["errors"]["global"]["absolute"]);
  EXPECT_EQ(last["dofs"], json["bodies"][0]["dofs"].get<int>() + json["bodies"][1]["dofs"].get<int>());
  EXPECT_LE(last["relative"], 0.05);
  EXPECT_TRUE(last["dofs_to_target"].is_null());
}

TEST_F(RunWithATarget, WritesItsHistoryAsATable)
{
  ASSERT_EQ(reach().exitCode, 0);
  const auto rows = table();
  const auto levels = summary("punch")["accuracy"]["levels"];
  EXPECT_THAT(rows.front(), ElementsAre("level", "dofs", "elements", "worst_shape", "sweeps", "bound", "relative",
                                        "mesh", "iteration", "largest_body", "largest_x", "largest_y", "dofs_to_target",
                                        "seconds", "energy_lower", "energy_upper", "guaranteed"));
  ASSERT_EQ(rows.size(), levels.size() + 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ASSERT_EQ(rows[i + 1].size(), rows.front().size());
    EXPECT_EQ(std::stoll(rows[i + 1][1]), levels[i]["dofs"].get<std::int64_t>());
    EXPECT_EQ(std::stod(rows[i + 1][5]), levels[i]["bound"].get<double>());
    EXPECT_EQ(std::stod(rows[i + 1][10]), levels[i]["largest"]["point"][0].get<double>());
    EXPECT_EQ(std::stod(rows[i + 1][14]), levels[i]["energy_bracket"]["lower"].get<double>());
    EXPECT_EQ(std::stod(rows[i + 1][15]), levels[i]["energy_bracket"]["upper"].get<double>());
  }
}

TEST_F(RunWithATarget, LeavesOutTheTableThatIsSwitchedOff)
{
  ASSERT_EQ(reach({"Output/Level Table=false"}).exitCode, 0);
  EXPECT_THAT(files(), ElementsAre("punch.contact.csv", "punch.e", "punch.summary.json"));
}

TEST_F(RunWithATarget, WritesEveryLevelOnlyWhenAsked)
{
  ASSERT_EQ(reach().exitCode, 0);
  EXPECT_THAT(files(), Not(Contains(HasSubstr("level-"))));
  writeFile(path("punch.level-01.e"), "");
  ASSERT_EQ(reach({"Output/All Levels=true"}).exitCode, 0);
  const auto levels = summary("punch")["accuracy"]["levels"].size();
  const auto names = files();
  EXPECT_EQ(std::size_t(std::count_if(names.begin(), names.end(),
                                      [](const auto& name) { return name.rfind("punch.level-", 0) == 0; })),
            levels);
  EXPECT_THAT(contentsOf(path("punch.level-01.e")), AllOf(StartsWith("CDF"), HasSubstr("eta_glob")));
  EXPECT_THAT(contentsOf(path("punch.e")), HasSubstr("eta_glob"));
}

TEST_F(RunWithATarget, RemovesTheLevelsOfALongerRun)
{
  ASSERT_EQ(reach({"Output/All Levels=true"}).exitCode, 0);
  EXPECT_EQ(reach({"Output/All Levels=true", "Accuracy/Maximum Levels=2"}).exitCode, 5);
  EXPECT_THAT(files(), ElementsAre("punch.contact.csv", "punch.e", "punch.level-01.e", "punch.level-02.e",
                                   "punch.levels.csv", "punch.summary.json"));
}

TEST_F(RunWithATarget, SpeaksOfLevelsOnTheScreen)
{
  const auto result = reach();
  EXPECT_THAT(result.out, HasSubstr("stopping: by the balance with the mesh, not by Tolerance"));
  EXPECT_THAT(result.out, HasSubstr("target 5 % reached: "));
  EXPECT_EQ(result.err, "");
}

TEST_F(RunWithATarget, MayExpectNumbersOfItsLevels)
{
  const auto expect = [](const std::string& quantity, const std::string& value) {
    return std::vector<std::string>{"Expect/e/Quantity=" + quantity, "Expect/e/Value=" + value, "Expect/e/Tolerance=0"};
  };
  EXPECT_EQ(reach(expect("accuracy/reached", "1")).exitCode, 0);
  EXPECT_EQ(reach(expect("accuracy/levels/1/level", "2")).exitCode, 0);
  EXPECT_EQ(reach(expect("accuracy/levels/99/level", "100")).exitCode, 4);
  EXPECT_THAT(reach(expect("accuracy/reach", "1")).err, HasSubstr("is not a number in this run's summary"));
  const auto without = callDeck("punch", expect("accuracy/reached", "1"));
  EXPECT_THAT(without.err, HasSubstr("is not a number in this run's summary"));
}

TEST_F(RunWithATarget, OfAStudyHasTheLastLevelInItsRow)
{
  const auto result =
      call({"-i", shippedDeck("punch"), "--study", "Accuracy/Target=0.1; 1e-3", "--set", "Accuracy/Maximum Dofs=300"});
  EXPECT_EQ(result.exitCode, 5) << result.err;
  const auto text = contentsOf(path("punch.study.csv"));
  EXPECT_THAT(text, HasSubstr("target 0.1 % missed: Maximum Dofs = 300"));
  EXPECT_THAT(files(), ElementsAre("punch.study.csv"));
}

TEST_F(RunWithATarget, ChecksAndPlansItsLevels)
{
  EXPECT_THAT(reach({"Accuracy/Maximum Levels=1"}).out, HasSubstr("1 level,"));
  const auto plan =
      call({"--plan", "-i", shippedDeck("punch"), "--set", "Accuracy/Target=0.05", "--set", "Output/All Levels=true"});
  EXPECT_THAT(plan.out, AllOf(HasSubstr("on every level"), HasSubstr("NAME.levels.csv"), HasSubstr("NAME.level-01.e")));
}

struct Limit
{
  std::string setting, words;
};

class LimitOfATarget : public RunWithATarget, public testing::WithParamInterface<Limit>
{};

TEST_P(LimitOfATarget, EndsWithTheBestAnswerAndExitCode5)
{
  const auto result = reach({GetParam().setting, "Accuracy/Target=1e-3"});
  EXPECT_EQ(result.exitCode, 5);
  EXPECT_THAT(result.err, AllOf(StartsWith("target 0.1 % missed: "), HasSubstr(GetParam().words),
                                HasSubstr("the answer is guaranteed to ")));
  EXPECT_THAT(result.out, HasSubstr("target 0.1 % NOT reached"));
  const auto json = summary("punch");
  EXPECT_FALSE(json["accuracy"]["reached"]);
  EXPECT_THAT(json["accuracy"]["limit"].get<std::string>(), HasSubstr(GetParam().words));
  EXPECT_TRUE(json["errors"]["global"]["guaranteed"]);
  EXPECT_THAT(files(), Contains("punch.e"));
}

INSTANTIATE_TEST_SUITE_P(All, LimitOfATarget,
                         testing::Values(Limit{"Accuracy/Maximum Levels=1", "Maximum Levels = 1"},
                                         Limit{"Accuracy/Maximum Dofs=100", "Maximum Dofs = 100"},
                                         Limit{"Accuracy/Maximum Time=1e-6", "Maximum Time = 1e-06 s"},
                                         Limit{"Accuracy/Maximum Memory=1e-6", "Maximum Memory = 1e-06 GB"},
                                         Limit{"Coupling/Stopping/Maximum Sweeps=1",
                                               "the sweeps do not converge (iteration "}));

TEST_F(RunWithATarget, WithoutASolutionEndsWithExitCode3)
{
  const auto result = reach({"Bodies/punch/Loads/press/Value=-1"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("the load does not press the bodies together"));
  EXPECT_THAT(summary("punch")["accuracy"]["limit"].get<std::string>(), HasSubstr("does not press"));
  EXPECT_EQ(table().size(), 1U);
}

TEST_F(RunWithATarget, ThatContactCannotDecideEndsWithExitCode3)
{
  EXPECT_EQ(reach({"Bodies/punch/Loads/press/Value=0", "Bodies/foundation/Loads/side/Type=Pressure",
                   "Bodies/foundation/Loads/side/Side=right", "Bodies/foundation/Loads/side/Value=1"})
                .exitCode,
            3);
}

struct Mistake
{
  std::string deck;
  std::vector<std::string> settings;
  std::string words;
};

class MistakenTarget : public ProgramFolder, public testing::WithParamInterface<Mistake>
{};

TEST_P(MistakenTarget, IsRefusedBeforeAnythingIsComputed)
{
  const auto result = callDeck(GetParam().deck, GetParam().settings);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr(GetParam().words), HasSubstr("1 error; nothing was computed.")));
  EXPECT_THAT(files(), ElementsAre());
}

TEST_P(MistakenTarget, IsFoundByCheckToo)
{
  std::vector<std::string> arguments{"--check", shippedDeck(GetParam().deck)};
  for (const auto& setting : GetParam().settings)
    arguments.insert(arguments.end(), {"--set", setting});
  const auto result = call(arguments);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr(GetParam().words));
}

INSTANTIATE_TEST_SUITE_P(
    All, MistakenTarget,
    testing::Values(
        Mistake{"punch", {"Accuracy/Of=Mean Stress"}, "names no target; give Target = 0.01, say, for 1 %."},
        Mistake{"punch", {"Accuracy/Target=0.1", "Accuracy/Absolute Target=1"}, "names both Target and Absolute"},
        Mistake{"punch", {"Accuracy/Target=0.1", "Error Estimation/Estimators={Residual}"}, "add \"Global\"."},
        Mistake{"punch", {"Accuracy/Target=0"}, "Target = 0 is outside (0, 1)"},
        Mistake{"punch", {"Accuracy/Target=1"}, "Target = 1 is outside (0, 1)"},
        Mistake{"punch",
                {"Accuracy/Target=0.1", "Accuracy/Iteration Share=0.2", "Accuracy/Stopping/Type=Tolerance"},
                "Iteration Share is for Stopping/Type = Balanced"},
        Mistake{"punch", {"Accuracy/Target=0.1", "Accuracy/Refinement/Type=Remesh"}, "refine by Bisection"},
        Mistake{"punch", {"Output/All Levels=true"}, "the deck has no list Accuracy"},
        Mistake{"punch",
                {"Accuracy/Target=0.1", "Output/All Levels=true", "Output/Exodus=false"},
                "All Levels writes Exodus files, and Exodus is false"},
        Mistake{"beam-3d", {"Accuracy/Target=0.1", "Accuracy/Refinement/Type=Remesh"}, "refine by Bisection"}));

TEST_F(RunWithATarget, ShowsBetweenWhichNodesContactEnds)
{
  const auto result = callDeck("contact-loss", {"Accuracy/Target=0.05"});
  ASSERT_THAT(result.exitCode, testing::AnyOf(0, 4)) << result.err;
  EXPECT_THAT(result.out, HasSubstr("contact: contact ends between ("));
  const auto interface = summary("contact-loss")["interfaces"][0];
  const auto brackets = interface["end_brackets"];
  ASSERT_EQ(brackets.size(), 1U);
  const double closed = brackets[0][0][0], open = brackets[0][1][0];
  EXPECT_EQ(closed, interface["end_points"][1][0].get<double>());
  EXPECT_LT(closed, open);
  EXPECT_NEAR(0.5 * (closed + open), 0.957, 0.1); // as a fine mesh has it
}

TEST_F(RunWithATarget, HasNoBracketWhereTheWholeSideIsClosed)
{
  ASSERT_EQ(reach().exitCode, 0);
  EXPECT_TRUE(summary("punch")["interfaces"][0]["end_brackets"].empty());
}

} // namespace
} // namespace ndframe::test
