// The program's studies: what a user types, sees and gets.

#include <map>
#include <sstream>

#include <gmock/gmock.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

namespace
{

/// A study of the punch by the program, in a folder of its own.
class StudyProgram : public testing::Test
{
protected:
  ProgramResult study(const std::vector<std::string>& axes, std::vector<std::string> more = {}) const
  {
    std::vector<std::string> arguments{"-i",    shippedDeck("punch"),
                                       "--set", "Bodies/punch/Mesh/Cells={5, 5}",
                                       "--set", "Bodies/foundation/Mesh/Cells={10, 5}"};
    for (const auto& axis : axes)
      arguments.insert(arguments.end(), {"--study", axis});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments, folder_.file("."));
  }
  /// The rows of the table, each by the names of the columns. Fields of these studies hold no quotes within.
  std::vector<std::map<std::string, std::string>> rows(const std::string& name = "punch") const
  {
    std::vector<std::map<std::string, std::string>> all;
    std::vector<std::string> names;
    std::istringstream text(contentsOf(folder_.file(name + ".study.csv")));
    for (std::string line; std::getline(text, line);) {
      const auto cells = fields(line);
      if (names.empty()) {
        names = cells;
        continue;
      }
      EXPECT_THAT(cells, SizeIs(names.size())) << line;
      all.emplace_back();
      for (std::size_t i = 0; i < cells.size(); ++i)
        all.back()[names[i]] = cells[i];
    }
    return all;
  }
  std::vector<std::string> column(const std::string& name, const std::string& study = "punch") const
  {
    std::vector<std::string> values;
    for (auto& row : rows(study))
      values.push_back(row.at(name));
    return values;
  }
  std::vector<std::string> files() const { return filesIn(folder_.file(".")); }
  const TemporaryFolder& folder() const { return folder_; }

private:
  static std::vector<std::string> fields(const std::string& line)
  {
    std::vector<std::string> all(1);
    bool quoted = false;
    for (const char c : line)
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        all.emplace_back();
      else
        all.back() += c;
    return all;
  }

  TemporaryFolder folder_;
};

} // namespace

TEST_F(StudyProgram, OfTolerancesFactorsEveryBodyOnce)
{
  const auto result = study({"Coupling/Stopping/Tolerance=0.1; 0.01; 1e-6"});
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(column("factorisations"), ElementsAre("2", "0", "0"));
  EXPECT_THAT(column("factors_reused"), ElementsAre("0", "2", "2"));
  EXPECT_THAT(column("Coupling/Stopping/Tolerance"), ElementsAre("0.1", "0.01", "1e-6"));
  EXPECT_THAT(files(), ElementsAre("punch.study.csv"));
  EXPECT_THAT(result.out, HasSubstr("3 cases: 2 factorisations; 4 factors and 4 meshes reused"));
}

TEST_F(StudyProgram, CombinesAxesTheLastOneFastest)
{
  const auto result = study({"Bodies/punch/Material/Young Modulus=1; 2", "Bodies/punch/Loads/press/Value=1; 1.0"});
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(column("Bodies/punch/Material/Young Modulus"), ElementsAre("1", "1", "2", "2"));
  EXPECT_THAT(column("Bodies/punch/Loads/press/Value"), ElementsAre("1", "1.0", "1", "1.0"));
  EXPECT_THAT(column("factorisations"), ElementsAre("2", "0", "1", "0"));
}

TEST_F(StudyProgram, MovesTheParametersOfAnAxisTogether)
{
  const auto result = study({"Bodies/punch/Mesh/Cells={4, 4}; {6, 6} && Bodies/foundation/Mesh/Cells={8, 4}; {12, 6}"});
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(column("Bodies/foundation/Mesh/Cells"), ElementsAre("{8, 4}", "{12, 6}"));
  EXPECT_THAT(column("factorisations"), ElementsAre("2", "2"));
}

TEST_F(StudyProgram, GivesEveryCaseTheNumbersOfARunOfItsOwn)
{
  ASSERT_EQ(study({"Coupling/Stopping/Tolerance=0.1; 1e-3"}).exitCode, 0);
  for (const auto& row : rows()) {
    const auto alone = Scene("punch")
                           .set("Bodies/punch/Mesh/Cells={5, 5}")
                           .set("Bodies/foundation/Mesh/Cells={10, 5}")
                           .set("Coupling/Stopping/Tolerance=" + row.at("Coupling/Stopping/Tolerance"))
                           .run();
    EXPECT_EQ(std::stod(row.at("energy")), alone.run.summary.energy);
    EXPECT_EQ(std::stoi(row.at("sweeps")), alone.run.summary.coupling->sweeps);
  }
}

TEST_F(StudyProgram, RefusesTheSameAxisTwice)
{
  const auto twice = study({"Coupling/Stopping/Tolerance=0.1; 0.01", " Coupling / Stopping/Tolerance =0.2; 0.3"});
  EXPECT_EQ(twice.exitCode, 2);
  EXPECT_THAT(twice.err, HasSubstr("--study: Coupling/Stopping/Tolerance is given twice; write all its values in one, "
                                   "with \";\" between them."));
  const auto joined = study({"Coupling/Stopping/Tolerance=0.1; 0.01 && Coupling/Stopping/Tolerance=0.2; 0.3"});
  EXPECT_EQ(joined.exitCode, 2);
  EXPECT_THAT(joined.err, HasSubstr("varies along another axis already"));
}

TEST_F(StudyProgram, RefusesAxesThatDoNothing)
{
  const std::string idle = "all its values give the same results; leave it out, or vary something that this deck uses.";
  for (const char* axis : {"Coupling/Relaxation/Theta=0.4; 0.40", "Title=one; two", "Output/Steps=Final; All Sweeps"}) {
    const auto result = study({"Bodies/punch/Material/Young Modulus=1; 2", axis});
    EXPECT_EQ(result.exitCode, 2) << axis;
    EXPECT_THAT(result.err, HasSubstr(idle)) << axis;
  }
  EXPECT_EQ(study({"Output/Steps=Final; All Sweeps"}, {"--set", "Study/Files=true"}).exitCode, 0);
  const auto alone = runProgram({"-i", shippedDeck("beam-3d"), "--study", "Coupling/Stopping/Tolerance=0.1; 0.01"},
                                folder().file("."));
  EXPECT_THAT(alone.err, HasSubstr(idle)) << "the deck has no interface";
}

TEST_F(StudyProgram, GoesOnAfterACaseThatFailsAndEndsWithTheGravestExitCode)
{
  const auto result = study({"Coupling/Stopping/Maximum Sweeps=2; 50", "Bodies/punch/Loads/press/Side=roof; top"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(column("exit_code"), ElementsAre("2", "3", "2", "0"));
  EXPECT_THAT(column("reason")[0], HasSubstr("there is no side roof")); // fields() drops the quotes
  EXPECT_THAT(column("reason")[1], StartsWith("not converged: "));
  EXPECT_THAT(column("energy")[0], "");
  EXPECT_THAT(column("converged")[1], "0");
}

TEST_F(StudyProgram, WritesTheFilesOfEveryCaseOnlyWhenAsked)
{
  ASSERT_EQ(study({"Coupling/Stopping/Tolerance=0.1; 0.05"}, {"--set", "Study/Files=true"}).exitCode, 0);
  EXPECT_THAT(files(), ElementsAre("punch.1.contact.csv", "punch.1.e", "punch.1.summary.json", "punch.2.contact.csv",
                                   "punch.2.e", "punch.2.summary.json", "punch.study.csv"));
}

TEST_F(StudyProgram, StandsInADeckToo)
{
  const auto result = runProgram({"-i", shippedDeck("study")}, folder().file("."));
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(files(), ElementsAre("study.study.csv"));
  EXPECT_THAT(column("factorisations", "study"), ElementsAre("2", "0", "0", "2", "0", "0"));
  EXPECT_THAT(column("Bodies/punch/Mesh/Cells", "study"),
              ElementsAre("{4, 4}", "{4, 4}", "{4, 4}", "{8, 8}", "{8, 8}", "{8, 8}"));
  EXPECT_THAT(column("Coupling/Stopping/Tolerance", "study"), ElementsAre("0.4", "0.1", "1e-3", "0.4", "0.1", "1e-3"));
  for (const auto& pressure : column("interfaces/contact/largest_pressure", "study"))
    EXPECT_GT(std::stod(pressure), 1.0);
}

TEST_F(StudyProgram, TakesTheValuesOfTheCommandLineForThoseOfItsDeck)
{
  const auto result =
      runProgram({"-i", shippedDeck("study"), "--study", "Coupling/Stopping/Tolerance=0.2"}, folder().file("."));
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(column("Coupling/Stopping/Tolerance", "study"), ElementsAre("0.2", "0.2"));
}

TEST_F(StudyProgram, PutsFieldsWithCommasAndQuotesInQuotes)
{
  ASSERT_EQ(study({"Bodies/punch/Mesh/Cells={5, 5}", "Bodies/punch/Loads/press/Side=roof"}).exitCode, 2);
  const auto text = contentsOf(folder().file("punch.study.csv"));
  EXPECT_THAT(text, HasSubstr("\n1,\"{5, 5}\",roof,"));
  EXPECT_THAT(text, HasSubstr("there is no side \"\"roof\"\""));
}

TEST_F(StudyProgram, FactorsNothingAgainAfterACaseThatIsRefused)
{
  ASSERT_EQ(study({"Bodies/punch/Loads/press/Side=top; roof; top"}).exitCode, 2);
  EXPECT_THAT(column("exit_code"), ElementsAre("0", "2", "0"));
  EXPECT_THAT(column("factorisations"), ElementsAre("2", "0", "0"));
}

TEST_F(StudyProgram, ReportsAllMistakesOfAllCasesAtOnce)
{
  const auto result = study({"Coupling/Relaxation/Theta=0.5; 2.5; x", "Coupling/Stoping/Tolerance=1", "no value",
                             "Bodies/punch/Mesh/Pattern=Right; Rigth"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("--study: \"no value\" is not \"List/Sublist/Key=value; value; ...\"."));
  EXPECT_THAT(result.err, HasSubstr("--study: Coupling/Relaxation: Theta = 2.5 is outside (0, 2)."));
  EXPECT_THAT(result.err, HasSubstr("Theta = \"x\" is not a number."));
  EXPECT_THAT(result.err, HasSubstr("Coupling: \"Stoping\" is not a list here; did you mean \"Stopping\"?"));
  EXPECT_THAT(result.err, HasSubstr("did you mean \"Right\"?"));
  EXPECT_THAT(result.err, HasSubstr("5 errors; nothing was computed."));
  EXPECT_THAT(files(), ElementsAre());
}

TEST_F(StudyProgram, RefusesParametersThatDoNotMoveTogether)
{
  const auto result = study({"Bodies/punch/Mesh/Cells={4, 4}; {6, 6} && Bodies/foundation/Mesh/Cells={8, 4}"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("the parameters of an axis move together, but Bodies/foundation/Mesh/Cells has 1 "
                                    "values and Bodies/punch/Mesh/Cells has 2."));
}

TEST_F(StudyProgram, RefusesColumnsThatNameNoNumber)
{
  const auto result = study({"Coupling/Stopping/Tolerance=0.1; 0.05"}, {"--set", "Study/Columns={energi}"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("\"energi\" is not a number in a case's summary"));
}

TEST_F(StudyProgram, GoesOnAfterACaseInWhichConjugateGradientsBreakDown)
{
  const std::string list = "Linear Solver/Preconditioner/";
  const auto result =
      runProgram({"-i", shippedDeck("krylov"), "--set", "Bodies/punch/Mesh/Cells={2, 2}", "--set",
                  "Bodies/foundation/Mesh/Cells={4, 2}", "--set", list + "Type=Ifpack2", "--set",
                  list + "Method=RELAXATION", "--set", "Expect/energy of this mesh whatever the solver/Tolerance=1",
                  "--study", list + "Ifpack2/relaxation: damping factor=-1.0; 1.0"},
                 folder().file("."));
  EXPECT_EQ(result.exitCode, 3) << result.err;
  EXPECT_THAT(column("exit_code", "krylov"), ElementsAre("3", "0"));
  EXPECT_THAT(column("reason", "krylov")[0], StartsWith("not converged: conjugate gradients met a motion"));
}

TEST_F(StudyProgram, ChecksAllItsCasesAndSolvesNone)
{
  const auto right = study({"Bodies/punch/Loads/press/Side=top; right"}, {"--check"});
  EXPECT_EQ(right.exitCode, 0) << right.err;
  EXPECT_THAT(right.out, HasSubstr("all 2 cases are valid; nothing was solved."));
  const auto wrong = study({"Bodies/punch/Loads/press/Side=top; roof; wall"}, {"--check"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("there is no side \"roof\""));
  EXPECT_THAT(wrong.err, HasSubstr("there is no side \"wall\""));
  EXPECT_THAT(files(), ElementsAre());
}

/// The mesh is the faster axis: a step of the tolerance goes back to the first mesh.
TEST_F(StudyProgram, DoesWhatItsPlanSays)
{
  const std::vector<std::string> axes{"Coupling/Stopping/Tolerance=0.1; 0.05",
                                      "Bodies/punch/Mesh/Pattern=Right; Crossed"};
  const auto plan = study(axes, {"--plan"});
  EXPECT_THAT(plan.out, HasSubstr("Tolerance           mesh, matrix and factor of punch\n"));
  EXPECT_THAT(plan.out, HasSubstr("Pattern             mesh, matrix and factor of punch\n"));
  EXPECT_THAT(plan.out, HasSubstr(".study.csv, one row per case\n"));
  ASSERT_EQ(study(axes).exitCode, 0);
  EXPECT_THAT(column("factorisations"), ElementsAre("2", "1", "1", "1"));
  EXPECT_THAT(column("meshes_reused"), ElementsAre("0", "1", "1", "1"));
}

TEST_F(StudyProgram, SaysInItsPlanWhatAStepComputesAgain)
{
  const auto result = study({"Bodies/punch/Mesh/Pattern=Right; Crossed", "Bodies/punch/Material/Young Modulus=1; 2",
                             "Coupling/Stopping/Tolerance=0.1; 0.05", "Coupling/Relaxation/Theta=0.5"},
                            {"--plan"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("8 cases: the first runs these stages, later ones reuse; "));
  EXPECT_THAT(result.out, HasSubstr("Pattern             mesh, matrix and factor of punch\n"));
  EXPECT_THAT(result.out, HasSubstr("Theta               nothing: it has one value\n"));
  EXPECT_THAT(result.out, HasSubstr("Young Modulus       matrix and factor of punch\n"));
  EXPECT_THAT(result.out, HasSubstr("Tolerance           the solution only: nothing read, assembled or factored\n"));
}
