// The program's options, exit codes and screen.

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>

#include "driver/program_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

namespace
{

class Program : public ProgramFolder
{
protected:
  /// The punch with settings.
  ProgramResult punch(const std::vector<std::string>& settings) const { return callDeck("punch", settings); }
};

class ShippedDeckRun : public Program, public testing::WithParamInterface<std::string>
{};

} // namespace

TEST_P(ShippedDeckRun, EndsWithExitCodeZero)
{
  const auto result = call({"-i", shippedDeck(GetParam())});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, "");
  const auto expectations = summary(GetParam())["expectations"];
  EXPECT_FALSE(expectations.empty()) << "every shipped deck says what it must give";
  for (const auto& expectation : expectations)
    EXPECT_TRUE(expectation["met"]) << expectation;
}

INSTANTIATE_TEST_SUITE_P(Decks, ShippedDeckRun, testing::ValuesIn(shippedDecks()),
                         [](const testing::TestParamInfo<std::string>& deck) {
                           std::string name = deck.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_F(Program, HelpKnowsTheReport)
{
  EXPECT_THAT(call({"--help"}).out, HasSubstr("report"));
  const auto result = call({"--help", "report"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out, AllOf(StartsWith("ndframe report NAME"), HasSubstr("python3-jinja2")));
}

TEST_F(Program, WithoutADeckSaysHowToGiveOne)
{
  const auto result = call({});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_EQ(result.err,
            "no deck was given; `ndframe new two-bodies` writes one to begin with, `ndframe --help` says more.\n"
            "1 error; nothing was computed.\n");
}

TEST_F(Program, RefusesDecksThatCannotBeRead)
{
  const auto missing = call({"-i", "nothing.xml"});
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_EQ(missing.err, "nothing.xml: cannot be opened: No such file or directory.\n1 error; nothing was computed.\n");
  const auto folder = call({"-i", "."});
  EXPECT_EQ(folder.exitCode, 2);
  EXPECT_EQ(folder.err, ".: is a directory, not a deck.\n1 error; nothing was computed.\n");
  writeFile(path("empty.xml"), "");
  const auto empty = call({"empty.xml"});
  EXPECT_EQ(empty.exitCode, 2);
  EXPECT_THAT(empty.err, StartsWith("empty.xml"));
}

TEST_F(Program, RefusesUnknownOptionsAndSecondDecks)
{
  const auto unknown = call({"--quick"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.err, AllOf(HasSubstr("--quick"), HasSubstr("`ndframe --help` shows the options.")));
  EXPECT_EQ(call({shippedDeck("punch"), shippedDeck("patch")}).exitCode, 2);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Program, NotConvergedEndsWithThreeAndMarkedResults)
{
  const auto result = punch({"Coupling/Stopping/Maximum Sweeps=3"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, AllOf(StartsWith("not converged: eps_tau 0.363 "), HasSubstr("in 3 sweeps (Maximum Sweeps)"),
                                EndsWith("; the results are marked so.\n")));
  EXPECT_THAT(files(), ElementsAre("punch.contact.csv", "punch.e", "punch.summary.json"));
  const auto coupling = summary("punch")["coupling"];
  EXPECT_EQ(coupling["converged"], false);
  EXPECT_EQ(coupling["sweeps"], 3);
  EXPECT_THAT(coupling["reason"], HasSubstr("Maximum Sweeps"));
}

TEST_F(Program, PullingABodyOffEndsWithThreeAndNamesTheMotion)
{
  for (const char* coupling : {"Coupling/Type=Neumann-Dirichlet", "Coupling/Type=Monolithic"}) {
    const auto result = punch({coupling, "Bodies/punch/Loads/press/Value=-1"});
    EXPECT_EQ(result.exitCode, 3) << coupling;
    EXPECT_THAT(result.err,
                HasSubstr("not converged: the load does not press the bodies together: it pulls off punch along +y;"));
    EXPECT_EQ(summary("punch")["coupling"]["converged"], false);
  }
}

TEST_F(Program, AMissedExpectationEndsWithFour)
{
  const auto result =
      punch({"Expect/mine/Quantity=coupling/sweeps", "Expect/mine/Value=99", "Expect/mine/Tolerance=1"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_EQ(result.err, "  MISSED mine: 6 instead of 99 +- 1\n");
  EXPECT_THAT(files(), testing::SizeIs(3));
}

TEST_F(Program, ExpectsNumbersOfASweepAndMissesThoseOfASweepThatWasNotMade)
{
  const std::vector<std::string> settings{"Expect/mine/Value=2", "Expect/mine/Tolerance=1e-12"};
  auto first = settings, hundredth = settings;
  first.push_back("Expect/mine/Quantity=coupling/history/0/eps_tau");
  hundredth.push_back("Expect/mine/Quantity=coupling/history/99/eps_tau");
  EXPECT_EQ(punch(first).exitCode, 0);
  EXPECT_EQ(punch(hundredth).exitCode, 4);
  EXPECT_TRUE(summary("punch")["expectations"].back()["value"].is_null());
}

TEST_F(Program, ChecksWithoutSolvingOrWriting)
{
  const auto result = call({"--check", shippedDeck("punch")});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out, HasSubstr("the deck is valid"));
  EXPECT_THAT(result.out, Not(HasSubstr("sweep")));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Program, PlansWithoutReadingAMesh)
{
  const auto result = call({"--plan", shippedDeck("gmsh-msh2"), "--set", "Bodies/punch/Mesh/File=nothing.msh", "--set",
                            "Output/Exodus=false"});
  EXPECT_EQ(result.exitCode, 0);
  for (const char* line :
       {"  gmsh                skip   no .geo script: the library is not loaded\n",
        "  mpi                 skip   one process: MPI is started for large solids alone\n",
        "  krylov              skip   no iterative linear solver is named: Tpetra is loaded for large solids alone\n",
        "  couple              run    Monolithic\n",
        "  certificate         skip   the deck has no list Error Estimation\n",
        "  stress              skip   no Exodus file is written\n", "  read                run    2 bodies\n"})
    EXPECT_THAT(result.out, HasSubstr(line));
  EXPECT_THAT(files(), IsEmpty());
}

/// A copy of the program looks for the module beside itself.
TEST_F(Program, NeedsTheKrylovModuleOnlyWhereADeckAsksForIt)
{
  std::filesystem::copy_file(programPath(), path("ndframe"));
  const auto copyCall = [this](const std::vector<std::string>& arguments) {
    return runProgram(arguments, path("."), path("ndframe"));
  };
  const auto refused = copyCall({"-i", shippedDeck("krylov")});
  EXPECT_EQ(refused.exitCode, 2);
  for (const char* words : {"the linear solver Krylov needs the module libndframe_krylov", "cannot open shared object",
                            "install all of ndframe, or use another linear solver."})
    EXPECT_THAT(refused.err, HasSubstr(words));
  EXPECT_THAT(files(), ElementsAre("ndframe"));
  EXPECT_EQ(copyCall({"--check", shippedDeck("punch")}).exitCode, 0);
  EXPECT_EQ(copyCall({"--help", "Krylov"}).exitCode, 0);
  EXPECT_EQ(copyCall({"--reference"}).out, contentsOf(NDFRAME_REFERENCE));
}

TEST_F(Program, RefusesNamesThatNoFileCanHaveBeforeItSolves)
{
  for (const std::size_t length : {220, 240, 251, 5000}) {
    const auto result = punch({"Output/Name=" + std::string(length, 'n')});
    EXPECT_EQ(result.exitCode, 2) << length;
    EXPECT_THAT(result.err, AllOf(HasSubstr(fmt::format("Output: the files' names would begin with {} char", length)),
                                  HasSubstr("give a shorter Name"), HasSubstr("nothing was computed")));
    EXPECT_THAT(result.out, Not(HasSubstr("eps_tau")));
  }
  for (const std::string& folder : {std::string(256, 'f'), "a/" + std::string(300, 'f') + "/b"})
    EXPECT_THAT(punch({"Output/Directory=" + folder}).err,
                HasSubstr("Directory is longer than the system lets a folder's path be"));
  const std::string deck = path(std::string(230, 'd') + ".xml");
  writeFile(deck, contentsOf(shippedDeck("punch")));
  EXPECT_THAT(call({"-i", deck}).err, HasSubstr("would begin with 230 characters"));
  std::filesystem::remove(deck);
  EXPECT_THAT(files(), IsEmpty());
  EXPECT_EQ(punch({"Output/Name=" + std::string(100, 'n')}).exitCode, 0);
}

TEST_F(Program, RefusesNamesOfBodiesAndInterfacesThatNoFieldCanHaveBeforeItSolves)
{
  for (const char* name : {"upper", "contact"})
    for (const std::size_t length : {240, 260}) {
      writeFile(path("long.xml"), std::regex_replace(contentsOf(shippedDeck("patch")),
                                                     std::regex(std::string("([\"/])") + name + "([\"/])"),
                                                     "$1" + std::string(length, name[0]) + "$2"));
      const auto result = call({"-i", path("long.xml")});
      EXPECT_EQ(result.exitCode, length < 256 ? 0 : 2) << result.err;
      if (length < 256)
        continue;
      EXPECT_THAT(result.err, AllOf(HasSubstr("characters in the Exodus file, which allows 256; shorten it"),
                                    HasSubstr("1 error; nothing was computed.")));
      EXPECT_THAT(result.out, Not(HasSubstr("eps_tau")));
      EXPECT_EQ(call({"-i", path("long.xml"), "--set", "Output/Exodus=false"}).exitCode, 0);
    }
}

TEST_F(Program, SaysWhenTheWorkingDirectoryIsGone)
{
  const auto inGone = [this](const std::string& arguments) {
    const std::string gone = path("gone"), err = path("err");
    const std::string script = "mkdir " + gone + "; cd " + gone + "; rmdir " + gone + "; " + programPath() + " -q -i " +
                               shippedDeck("punch") + arguments + " 2> " + err;
    const int status = std::system(script.c_str());
    return std::pair(WEXITSTATUS(status), contentsOf(err));
  };
  const auto [code, message] = inGone("");
  EXPECT_EQ(code, 2);
  EXPECT_THAT(message, HasSubstr("Output: the working directory does not exist any more"));
  EXPECT_EQ(inGone(" --set Output/Directory=" + path("there")).first, 0);
  EXPECT_TRUE(std::filesystem::exists(path("there/punch.e")));
}

TEST_F(Program, PlansItsMemoryAndRefusesWhatCannotFit)
{
  EXPECT_THAT(call({"--plan", shippedDeck("punch")}).out,
              testing::ContainsRegex("\n  memory: about 0.03[0-9]* GB for some 5 704 dofs; .* GB \\(.*\\) left\n"));
  EXPECT_THAT(call({"--plan", shippedDeck("gmsh-msh2")}).out,
              HasSubstr("memory: checked when the mesh files are read"));
  EXPECT_THAT(call({"--plan", shippedDeck("krylov")}).out, HasSubstr("memory: not estimated for Krylov"));
  EXPECT_THAT(call({"--plan", shippedDeck("punch-3d"), "--set", "Linear Solver/Type=Multigrid"}).out,
              HasSubstr("memory: about 0.12 GB for some 18 546 dofs;"));
  // A large solid has no factor, unless its volume hardly changes; a bound takes more than the solution.
  const auto large = [this](std::vector<std::string> more) {
    more.insert(more.begin(), {"--plan", shippedDeck("punch-3d"), "--set", "Bodies/punch/Mesh/Cells={20, 20, 20}",
                               "--set", "Bodies/foundation/Mesh/Cells={40, 40, 20}"});
    return call(more).out;
  };
  EXPECT_THAT(large({}), HasSubstr("memory: about 2 GB for some 1 013 766 dofs;"));
  EXPECT_THAT(large({"--set", "Error Estimation/Estimators={}"}),
              HasSubstr("memory: about 1.4 GB for some 1 013 766 dofs;"));
  EXPECT_THAT(large({"--set", "Bodies/punch/Material/Poisson Ratio=0.499"}),
              HasSubstr("memory: about 18 GB for some 1 013 766 dofs;"));
  EXPECT_THAT(
      large({"--set", "Bodies/punch/Mesh/Refine=4", "--set", "Bodies/foundation/Mesh/Refine=4"}),
      testing::ContainsRegex("left: NOT ENOUGH; [0-9]+ machines like this one, with a process each, would do\n"));
  EXPECT_THAT(call({"--plan", shippedDeck("punch"), "--set", "Bodies/punch/Mesh/Cells={20000, 20000}"}).out,
              HasSubstr("left: NOT ENOUGH"));
}

TEST_F(Program, ListsAllComponents)
{
  const auto result = call({"--list"});
  EXPECT_EQ(result.exitCode, 0);
  for (const auto* choices :
       {&components().meshSources.choices(), &components().materials.choices(), &components().supports.choices(),
        &components().loads.choices(), &components().linearSolvers.choices(),
        &components().interfaceOperators.choices(), &components().relaxations.choices(),
        &components().couplings.choices(), &components().recoveries.choices()})
    for (const auto& component : choices->components)
      EXPECT_THAT(result.out, HasSubstr("\n  " + component.name + " "));
}

TEST_F(Program, ExplainsItselfAndEveryList)
{
  const auto help = call({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  for (const char* text : {"--input", "--check", "--plan", "--set", "--help", "--list", "--dump-defaults", "--version",
                           "--quiet", "--verbose", "Exit codes: 0 success"})
    EXPECT_THAT(help.out, HasSubstr(text));
  EXPECT_THAT(help.out, HasSubstr("To begin: `ndframe new two-bodies`"));
  const auto aitken = call({"--help", "Aitken"});
  EXPECT_EQ(aitken.exitCode, 0);
  EXPECT_THAT(aitken.out, AllOf(HasSubstr("Initial Theta"), HasSubstr("in (0, 2)")));
  EXPECT_THAT(call({"--help", "Coupling/Stopping"}).out, HasSubstr("Maximum Sweeps"));
  EXPECT_THAT(call({"--help", "units"}).out, HasSubstr("with lengths in mm and moduli in MPa"));
  const auto wrong = call({"--help", "Aitkin"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean \"Aitken\"?"));
}

TEST_F(Program, ShowsItsVersion)
{
  const auto result = call({"--version"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out,
              testing::ContainsRegex("^ndframe [0-9]+\\.[0-9]+\\.[0-9]+\ncommit [0-9a-z]+, [A-Za-z]+ build, GNU"));
  for (const char* library : {"\nTrilinos ", "\nCHOLMOD ", "\nOpen MPI "})
    EXPECT_THAT(result.out, HasSubstr(library));
  EXPECT_THAT(result.out,
              testing::ContainsRegex("\nhere: [0-9]+ threads? per process .OMP_NUM_THREADS., 1 process .mpirun.\n"));
}

TEST_F(Program, DumpsDefaultsThatRunAndDumpToThemselves)
{
  const auto dump = call({"--dump-defaults"});
  EXPECT_EQ(dump.exitCode, 0);
  writeFile(path("defaults.xml"), dump.out);
  const auto result = call({"defaults.xml"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(toXml(Scene::fromFile(path("defaults.xml")).params()), dump.out);
}

TEST_F(Program, IsSilentWithQAndTellsMoreWithV)
{
  const auto quiet = call({"-q", shippedDeck("punch")});
  EXPECT_EQ(quiet.exitCode, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const auto verbose = call({"-v", shippedDeck("punch")}), normal = call({shippedDeck("punch")});
  EXPECT_GT(verbose.out.size(), normal.out.size());
  EXPECT_THAT(verbose.out, HasSubstr("nonzeros"));
}

TEST_F(Program, ShowsHeaderSweepsAndTablesOnAPipeWithoutControlCharacters)
{
  const auto result = call({shippedDeck("contact-loss")});
  for (const char* text : {"Punch with partial contact loss", "dofs", "interface nodes", "eps_tau", "theta", "changed",
                           "force on upper", "force on lower", "penetration", "energy a(u,u)", "contact force",
                           "contact length", "largest pressure", "seconds", "MB", "wrote contact-loss.e"})
    EXPECT_THAT(result.out, HasSubstr(text));
  for (const unsigned char c : result.out)
    EXPECT_TRUE(c == '\n' || !std::iscntrl(c)) << int(c);
  const auto sweeps = summary("contact-loss")["coupling"]["sweeps"].get<int>();
  EXPECT_THAT(result.out,
              HasSubstr("\n  " + std::string(5 - std::to_string(sweeps).size(), ' ') + std::to_string(sweeps) + "   "));
}

TEST_F(Program, ShowsTheCertificateAndItsReasonWhenItIsNone)
{
  const auto strict = punch({"Error Estimation/Mode=Strict"});
  EXPECT_EQ(strict.exitCode, 0);
  EXPECT_THAT(strict.out,
              testing::ContainsRegex("\n  error in energy +<= .* % +of the solution, guaranteed\n    mesh .* %"));
  const auto paper = punch({"Error Estimation/Mode=Paper"});
  EXPECT_EQ(paper.exitCode, 0);
  EXPECT_THAT(paper.out, testing::ContainsRegex("\n  error in energy +~ .* not guaranteed: .*Paper"));
  EXPECT_EQ(summary("punch")["errors"]["global"]["guaranteed"], false);
}

TEST_F(Program, AMissingGuaranteeEndsWithThreeOnlyWhereItIsRequired)
{
  const auto beam = [&](const std::string& isRequired) {
    return call({"-i", shippedDeck("beam-3d"), "--set", "Bodies/beam/Loads/bending/X=sqrt(max(0, 0.1 - y*y - z*z))",
                 "--set", "Expect/exact energy/Tolerance=1", "--set",
                 "Error Estimation/Require Guarantee=" + isRequired});
  };
  EXPECT_EQ(beam("false").exitCode, 0);
  const auto required = beam("true");
  EXPECT_EQ(required.exitCode, 3);
  EXPECT_THAT(required.err, AllOf(StartsWith("the bound is not guaranteed: "), HasSubstr("not certain near"),
                                  EndsWith("the results are marked so.\n")));
  EXPECT_EQ(summary("beam-3d")["errors"]["global"]["guaranteed"], false);
}

/// There is no solution, so there is no error of it.
TEST_F(Program, PullingABodyOffLeavesNothingToCertify)
{
  const auto result = punch({"Error Estimation/Require Guarantee=true", "Bodies/punch/Loads/press/Value=-1"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("the load does not press the bodies together: it pulls off punch along +y;"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("error in energy")));
  EXPECT_TRUE(summary("punch")["errors"].is_null());
}

TEST_F(Program, ExpectsNumbersOfTheCertificate)
{
  const auto result = punch({"Error Estimation/Estimators={Global}", "Expect/mine/Quantity=errors/global/guaranteed",
                             "Expect/mine/Value=1", "Expect/mine/Tolerance=0"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
}

TEST_F(Program, ReferenceIsUpToDate)
{
  const auto reference = call({"--reference"});
  EXPECT_EQ(reference.exitCode, 0);
  EXPECT_TRUE(contentsOf(NDFRAME_REFERENCE) == reference.out)
      << "docs/reference.md is out of date; write it anew:  ndframe --reference > docs/reference.md";
}
