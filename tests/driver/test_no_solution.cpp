// Runs that end without a solution: what they leave, and what they do not leave of an earlier run.

#include <gmock/gmock.h>

#include "driver/program_folder.hpp"

using namespace ndframe::test;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using Json = nlohmann::json;

namespace
{

/// Small punches, one call after the other in the same folder.
class NoSolution : public ProgramFolder
{
protected:
  ProgramResult punch(std::vector<std::string> settings, const std::string& mode = "--set") const
  {
    std::vector<std::string> arguments{"-i", shippedDeck("punch")};
    settings.insert(settings.end(), {"Bodies/punch/Mesh/Cells={6, 6}", "Bodies/foundation/Mesh/Cells={12, 6}"});
    for (std::size_t i = 0; i < settings.size(); ++i)
      arguments.insert(arguments.end(), {i == 0 ? mode : "--set", settings[i]});
    return call(arguments);
  }
  Json summary() const { return ProgramFolder::summary("punch"); }
};

const char* const pulledOff = "Bodies/punch/Loads/press/Value=-1";

} // namespace

TEST_F(NoSolution, LeavesOnlyItsSummaryWhereAnEarlierRunLeftFields)
{
  punch({"Title=before"});
  ASSERT_THAT(files(), ElementsAre("punch.contact.csv", "punch.e", "punch.summary.json"));
  const auto result = punch({pulledOff});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err,
              EndsWith("; there is no solution: none is written, and files of an earlier one are removed.\n"));
  EXPECT_THAT(files(), ElementsAre("punch.summary.json"));
}

TEST_F(NoSolution, LeavesFilesThatTheDeckDoesNotAskFor)
{
  punch({"Title=before"});
  punch({pulledOff, "Output/Exodus=false", "Output/Contact Table=false"});
  EXPECT_THAT(files(), ElementsAre("punch.contact.csv", "punch.e", "punch.summary.json"));
}

TEST_F(NoSolution, HasNullForEveryNumberOfTheSolution)
{
  punch({pulledOff});
  const Json summary = this->summary();
  EXPECT_TRUE(summary["energy"].is_null());
  for (const auto& body : summary["bodies"])
    EXPECT_TRUE(body["energy"].is_null() && body["dofs"].is_number());
  for (const char* key : {"closed_nodes", "contact_force", "contact_length", "end_points", "force_on_dirichlet",
                          "force_on_neumann", "largest_penetration", "largest_pressure"})
    EXPECT_TRUE(summary["interfaces"][0][key].is_null()) << key;
  for (const auto& residual : summary["residuals"])
    EXPECT_TRUE(residual.is_null());
  EXPECT_TRUE(summary["coupling"]["sweeps"].is_null());
  EXPECT_EQ(summary["coupling"]["converged"], false);
}

TEST_F(NoSolution, OfASolverThatGivesUpIsSummarizedWithTheReason)
{
  const auto result = punch(
      {"Linear Solver/Type=Krylov", "Linear Solver/Preconditioner/Type=Ifpack2", "Linear Solver/Maximum Iterations=3"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(files(), ElementsAre("punch.summary.json"));
  EXPECT_TRUE(summary()["energy"].is_null());
  EXPECT_THAT(summary()["coupling"]["reason"], HasSubstr("after 3 iterations"));
}

TEST_F(NoSolution, IsADashOnTheScreenAndEmptyInTheTableOfAStudy)
{
  const auto result = punch({"Bodies/punch/Loads/press/Value=-1; 1"}, "--study");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.out, HasSubstr("     1     -1      988            -      -         -"));
  EXPECT_THAT(contentsOf(path("punch.study.csv")), HasSubstr("\n1,-1,988,,,,0,"));
}

TEST_F(NoSolution, IsNotBlamedOnTheMatrixWhereTheSolversToleranceIsLoose)
{
  const auto result =
      punch({"Linear Solver/Type=Krylov", "Linear Solver/Preconditioner/Type=Ifpack2", "Linear Solver/Tolerance=1e-2"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("the linear solver's Tolerance 0.01 is too loose; lower it"));
}
