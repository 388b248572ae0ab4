// The files a run leaves: which, where, and what the small ones hold. Python reads the Exodus file and the summary
// back.

#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>

#include "driver/program_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::IsEmpty;
using Json = nlohmann::json;

namespace
{

class Output : public ProgramFolder
{
protected:
  /// Files that a shipped deck leaves in the working directory with these settings.
  std::vector<std::string> filesOf(const std::string& deck, const std::vector<std::string>& settings) const
  {
    const auto result = callDeck(deck, settings);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return files();
  }
};

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

} // namespace

TEST_F(Output, StandsInTheWorkingDirectoryUnderTheDecksName)
{
  EXPECT_THAT(filesOf("punch", {}), ElementsAre("punch.contact.csv", "punch.e", "punch.summary.json"));
}

TEST_F(Output, HasNoContactTableWithoutAnInterface)
{
  EXPECT_THAT(filesOf("beam-3d", {}), ElementsAre("beam-3d.e", "beam-3d.summary.json"));
}

TEST_F(Output, StandsWhereDirectoryAndNameSay)
{
  EXPECT_THAT(filesOf("punch", {"Output/Directory=a/b", "Output/Name=first.try"}), ElementsAre("a"));
  EXPECT_THAT(filesIn(path("a/b")), ElementsAre("first.try.contact.csv", "first.try.e", "first.try.summary.json"));
}

TEST_F(Output, IsWrittenOnlyWhereItIsSwitchedOn)
{
  EXPECT_THAT(filesOf("punch", {"Output/Exodus=false", "Output/Summary=false", "Output/Contact Table=false"}),
              IsEmpty());
  EXPECT_THAT(filesOf("punch", {"Output/Exodus=false", "Output/Summary=false"}), ElementsAre("punch.contact.csv"));
  EXPECT_THAT(filesOf("punch", {"Output/Name=s", "Output/Exodus=false", "Output/Contact Table=false"}),
              ElementsAre("punch.contact.csv", "s.summary.json"));
  EXPECT_THAT(filesOf("punch", {"Output/Name=t", "Output/Summary=false", "Output/Contact Table=false"}),
              ElementsAre("punch.contact.csv", "s.summary.json", "t.e"));
}

TEST_F(Output, ReplacesTheFilesOfAnEarlierRun)
{
  writeFile(path("punch.summary.json"), "old");
  filesOf("punch", {});
  EXPECT_EQ(Json::parse(contentsOf(path("punch.summary.json")))["title"], "Punch on a foundation");
}

TEST_F(Output, ThatCannotBeWrittenEndsWithTwoAndKeepsTheOldFile)
{
  std::filesystem::create_directory(path("punch.e"));
  const auto result = runProgram({"-q", shippedDeck("punch")}, path("."));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, testing::AllOf(testing::HasSubstr("punch.e"),
                                         testing::EndsWith("1 error; the results could not be written.\n")));
  EXPECT_THAT(filesIn(path(".")), ElementsAre("punch.e"));
}

TEST_F(Output, ContactTableHoldsEveryNodeOfTheInterface)
{
  filesOf("contact-loss", {});
  const auto lines = split(contentsOf(path("contact-loss.contact.csv")), '\n');
  EXPECT_EQ(lines.front(),
            "interface,x,y,arc_length,pressure,gap,u_dirichlet,u_neumann,traction_dirichlet,traction_neumann,"
            "nodal_force,closed");
  const auto contact = Json::parse(contentsOf(path("contact-loss.summary.json")))["interfaces"][0];
  ASSERT_EQ(lines.size(), 1U + contact["nodes"].get<std::size_t>());
  double force = 0.0;
  int closed = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = split(lines[i], ',');
    ASSERT_EQ(cells.size(), 12U);
    EXPECT_EQ(cells[0], "contact");
    EXPECT_NEAR(std::stod(cells[6]) - std::stod(cells[7]), -std::stod(cells[5]), 1e-14) << "no gap at the start";
    force -= std::stod(cells[10]);
    closed += std::stoi(cells[11]);
    EXPECT_TRUE(cells[11] == "1" || cells[4] == "0") << "no pressure where contact is open";
  }
  EXPECT_NEAR(force, 0.5, 1e-10);
  EXPECT_EQ(closed, contact["closed_nodes"]);
}
