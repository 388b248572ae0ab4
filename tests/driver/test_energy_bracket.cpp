// The exact energy in a bracket: closed forms, its width, and certificates of one scene that bind each other.

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "study.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

/// One block of 2 x 3, E = 8, nu = 0, on rollers at its left and its bottom; plane stress.
Scene block(const std::string& supports, const std::string& loads)
{
  return Scene::fromText(R"xml(<ParameterList name="block"><ParameterList name="Bodies"><ParameterList name="block">
    <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
      <Parameter name="Lower" type="Array(double)" value="{0, 0}"/><Parameter name="Upper" type="Array(double)" value="{2, 3}"/>
      <Parameter name="Cells" type="Array(int)" value="{3, 4}"/></ParameterList>
    <ParameterList name="Material"><Parameter name="Young Modulus" type="double" value="8"/>
      <Parameter name="Poisson Ratio" type="double" value="0"/><Parameter name="Hypothesis" type="string" value="Plane Stress"/></ParameterList>
    <ParameterList name="Supports"><ParameterList name="left"><Parameter name="Type" type="string" value="Roller"/>
        <Parameter name="Side" type="string" value="left"/></ParameterList>
      <ParameterList name="bottom"><Parameter name="Type" type="string" value="Roller"/>
        <Parameter name="Side" type="string" value="bottom"/></ParameterList>)xml" +
                         supports + R"(</ParameterList><ParameterList name="Loads">)" + loads +
                         R"(</ParameterList></ParameterList></ParameterList></ParameterList>)")
      .set("Error Estimation/Estimators={Global}");
}

std::string onTop(const std::string& type, const std::string& key, const std::string& value)
{
  return R"(<ParameterList name="top"><Parameter name="Type" type="string" value=")" + type +
         R"("/><Parameter name="Side" type="string" value="top"/><Parameter name=")" + key +
         R"(" type="string" value=")" + value + R"("/></ParameterList>)";
}

Scene pressed(const std::string& pressure)
{
  return block("", onTop("Pressure", "Value", pressure));
}

Scene moved(const std::string& displacement)
{
  return block(onTop("Displacement", "Y", displacement), "");
}

Scene punch(const std::string& cells = "4")
{
  return Scene("punch")
      .set("Error Estimation/Estimators={Global}")
      .set("Bodies/punch/Mesh/Cells={" + cells + ", " + cells + "}")
      .set("Bodies/foundation/Mesh/Cells={" + std::to_string(2 * std::stoi(cells)) + ", " + cells + "}");
}

EnergySummary energyOf(const Scene& scene)
{
  const auto outcome = scene.run();
  EXPECT_EQ(outcome.run.failure, "");
  EXPECT_TRUE(outcome.run.summary.errors->energyBracket.has_value()) << outcome.run.summary.errors->reason;
  return outcome.run.summary.errors->energyBracket.value_or(EnergySummary());
}

void expectHolds(const NumberBracket& bracket, double exact, double tolerance = 1e-9)
{
  EXPECT_LE(bracket.lower, exact + tolerance * std::abs(exact));
  EXPECT_GE(bracket.upper, exact - tolerance * std::abs(exact));
}

/// All certificates of a scene, each by a run of its own.
void expectTogether(const std::vector<Scene>& scenes)
{
  EnergyRecord record;
  for (const Scene& scene : scenes) {
    const auto outcome = scene.run();
    ASSERT_TRUE(outcome.run.certificate && outcome.run.certificate->energy)
        << outcome.run.failure << outcome.run.summary.errors->reason;
    const EnergyBracket bracket = *outcome.run.certificate->energy;
    EXPECT_LE(bracket.lower, bracket.upper + bracket.roundOff);
    const auto contradiction = record.add(bracket, std::to_string(record.certificates()));
    EXPECT_FALSE(contradiction.has_value()) << contradiction->earlier << " " << contradiction->later << " "
                                            << contradiction->lower << " > " << contradiction->upper;
  }
}

/// What the load "Forgetful" has as its value now; with `perModel` more for every model that is made.
double forgetfulValue = 1.0, perModel = 0.0;

/// A pressure that each mesh sees with another value.
class Forgetful final : public Load
{
public:
  explicit Forgetful(const Params& params) : Load(params) { forgetfulValue += perModel; }
  std::vector<SampledFunction> functions(int) const override { return {sampled("Value")}; }
  void density(int dim, const double* values, const double* normal, double* q) const override
  {
    for (int k = 0; k < dim; ++k)
      q[k] = -forgetfulValue * values[0] * normal[k];
  }
};

const Components& withForgetful()
{
  static const auto all = makeComponents([](Components& components) {
    components.loads.add("Forgetful", "A load that is not what it was.",
                         {sideSpec(), ParamSpec::required("Value", Kind::Expression, "The pressure.")},
                         [](const Params& p) { return std::make_unique<Forgetful>(p); });
  });
  return *all;
}

DeckList forgetfulList(const std::vector<std::string>& settings)
{
  Scene scene = punch();
  scene.changeAll("Type", [](const std::string& type) { return type == "Pressure" ? "Forgetful" : type; });
  for (const auto& setting : settings)
    scene.set(setting);
  return scene.deck();
}

Params forgetfulDeck(const std::vector<std::string>& settings)
{
  Diagnostics diagnostics;
  const Params deck = validate(forgetfulList(settings), makeDeckSpec(withForgetful()), diagnostics);
  diagnostics.throwIfAny();
  return deck;
}

} // namespace

TEST(EnergyBracket, OfUniformPressureHasTheClosedForm)
{
  // u = p y / E: u(3) = 0.3 for p = 0.8; F = 1.6.
  const EnergySummary summary = energyOf(pressed("0.8"));
  expectHolds(summary.energy, -0.5 * 1.6 * 0.3);
  EXPECT_LT(summary.relativeWidth, 1e-12);
  ASSERT_TRUE(summary.work && summary.drive);
  EXPECT_EQ(summary.workOf, "the loads");
  expectHolds(*summary.work, 1.6 * 0.3);
  EXPECT_EQ(summary.drive->cause, "top of block");
  expectHolds(summary.drive->force, 1.6);
  expectHolds(summary.drive->displacement, 0.3);
  expectHolds(summary.drive->stiffness, 1.6 / 0.3);
}

TEST(EnergyBracket, OfAPrescribedDisplacementHasTheClosedForm)
{
  const EnergySummary summary = energyOf(moved("-0.3"));
  expectHolds(summary.energy, 0.5 * 1.6 * 0.3);
  ASSERT_TRUE(summary.work && summary.drive);
  EXPECT_EQ(summary.workOf, "the supports");
  expectHolds(*summary.work, 1.6 * 0.3);
  expectHolds(summary.drive->force, 1.6);
  expectHolds(summary.drive->displacement, 0.3);
  expectHolds(summary.drive->stiffness, 1.6 / 0.3);
}

TEST(EnergyBracket, SaysNothingOfWorkWhereTheEnergyDoesNot)
{
  EXPECT_FALSE(energyOf(block(onTop("Displacement", "Y", "-0.1"),
                              R"(<ParameterList name="b"><Parameter name="Type" type="string" value="Body Force"/>
                                 <Parameter name="X" type="string" value="1"/></ParameterList>)"))
                   .work);
  EXPECT_FALSE(energyOf(punch().set("Interfaces/contact/Gap=0.01")).work);
  EXPECT_FALSE(energyOf(punch().set("Interfaces/contact/Gap=0.01*x")).work);
  const EnergySummary varies = energyOf(punch().set("Bodies/punch/Loads/press/Value=1+x"));
  EXPECT_TRUE(varies.work);
  EXPECT_FALSE(varies.drive);
}

TEST(EnergyBracket, IsAsWideAsTheSquareOfTheBoundSays)
{
  for (const auto& scene : {punch(), punch().set("Interfaces/contact/Gap=0.05*x^2"), pressed("1+x^2")}) {
    const auto outcome = scene.run();
    const ErrorMeasureSummary& bound = *outcome.run.summary.errors->global;
    const EnergySummary& summary = *outcome.run.summary.errors->energyBracket;
    const double norm = bound.absolute / bound.relative, widened = bound.elements + bound.oscillation;
    EXPECT_GE(summary.relativeWidth * norm * norm * (1.0 + 1e-6),
              std::pow(bound.elements, 2) + std::pow(bound.contact, 2));
    EXPECT_LE(summary.relativeWidth * norm * norm * (1.0 - 1e-6), std::pow(widened, 2) + std::pow(bound.contact, 2));
    if (bound.contact == 0.0 && bound.projection == 0.0 && bound.oscillation == 0.0) {
      EXPECT_NEAR(summary.relativeWidth, bound.relative * bound.relative, 1e-7 * summary.relativeWidth);
    }
    EXPECT_LE(summary.relativeWidth, 2.0 * bound.relative * bound.relative);
  }
}

TEST(EnergyBracket, MeshesOrdersSweepsAndCouplingsAgree)
{
  std::vector<Scene> scenes;
  for (const char* cells : {"3", "5", "16"})
    for (const char* order : {"1", "2"})
      for (const char* coupling : {"Neumann-Dirichlet", "Monolithic"})
        scenes.push_back(punch(cells)
                             .set(std::string("Discretization/Order=") + order)
                             .set(std::string("Coupling/Type=") + coupling));
  scenes.push_back(punch("4").set("Coupling/Stopping/Tolerance=1e-9").set("Error Estimation/Recovery/Sweeps=2"));
  scenes.push_back(punch("6").set("Coupling/Stopping/Tolerance=0.9"));
  expectTogether(scenes);
}

TEST(EnergyBracket, MeshesAgreeOnGapsAndDataThatAreNoPolynomials)
{
  for (const char* setting : {"Interfaces/contact/Gap=0.02+0.3*x^2", "Interfaces/contact/Gap=0.1*(1-cos(x))",
                              "Bodies/punch/Loads/press/Value=1+sin(5*x)", "Bodies/punch/Loads/press/Value=exp(-4*x)"})
  {
    std::vector<Scene> scenes;
    for (const char* cells : {"3", "5", "9", "14"})
      for (const char* order : {"1", "2"})
        scenes.push_back(punch(cells)
                             .set(setting)
                             .set(std::string("Discretization/Order=") + order)
                             .set("Coupling/Type=Monolithic"));
    expectTogether(scenes);
  }
}

TEST(EnergyBracket, MeshesAgreeOnPrescribedDisplacementsThatAreMetAtNodesOnly)
{
  std::vector<Scene> scenes;
  for (const char* cells : {"{2, 3}", "{3, 4}", "{7, 5}", "{20, 30}"})
    for (const char* order : {"1", "2"})
      scenes.push_back(moved("-0.1*(1+sin(3*x))")
                           .set(std::string("Bodies/block/Mesh/Cells=") + cells)
                           .set(std::string("Discretization/Order=") + order));
  expectTogether(scenes);
}

TEST(EnergyBracket, OfLevelsOnlyBecomesNarrower)
{
  const auto outcome = punch().set("Accuracy/Target=0.01").run();
  const auto& levels = outcome.run.summary.accuracy->levels;
  ASSERT_GE(levels.size(), 3u);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    ASSERT_TRUE(levels[l].energy.has_value());
    EXPECT_LE(levels[l].energy->lower, levels[l].energy->upper);
    if (l > 0) {
      EXPECT_GE(levels[l].energy->lower, levels[l - 1].energy->lower);
      EXPECT_LE(levels[l].energy->upper, levels[l - 1].energy->upper);
    }
  }
  EXPECT_EQ(levels.back().energy->upper, outcome.run.summary.errors->energyBracket->energy.upper);
  EXPECT_LT(outcome.run.summary.errors->energyBracket->relativeWidth, 1e-4);
}

TEST(ContradictingCertificates, OfTwoLevelsEndTheRunWithoutAGuarantee)
{
  for (const double later : {3.0, 0.2}) {
    forgetfulValue = 1.0;
    const LevelObserver change = [&](const ndframe::Run&, int level) { forgetfulValue = level == 1 ? 1.0 : later; };
    Ledger ledger;
    const ndframe::Run run = runDeck(forgetfulDeck({"Accuracy/Target=0.001"}), withForgetful(), Comm::single(), ledger,
                                     silentLog(), {}, change);
    EXPECT_THAT(run.failure, HasSubstr("contradict each other"));
    EXPECT_THAT(run.failure, HasSubstr("level 3"));
    EXPECT_FALSE(run.summary.errors->guaranteed);
    EXPECT_EQ(run.summary.errors->reason, run.failure);
    EXPECT_FALSE(run.summary.errors->energyBracket.has_value());
    const AccuracySummary& accuracy = *run.summary.accuracy;
    EXPECT_FALSE(accuracy.reached);
    EXPECT_THAT(accuracy.limit, HasSubstr("contradict each other"));
    EXPECT_EQ(accuracy.levels.size(), 3u);
    EXPECT_EQ(accuracy.written, 3);
  }
}

TEST(ContradictingCertificates, AreSeenWhereTheLaterOneReachesTheTarget)
{
  forgetfulValue = 1.0;
  const LevelObserver change = [&](const ndframe::Run&, int) { forgetfulValue = 3.0; };
  Ledger ledger;
  const ndframe::Run run = runDeck(forgetfulDeck({"Accuracy/Target=0.05"}), withForgetful(), Comm::single(), ledger,
                                   silentLog(), {}, change);
  EXPECT_THAT(run.failure, HasSubstr("contradict each other"));
  EXPECT_FALSE(run.summary.accuracy->reached);
}

TEST(ContradictingCertificates, OfARunAndTheNextAreSeen)
{
  const auto runAfter = [](Reusable&& previous, const std::string& cells, double value) {
    forgetfulValue = value;
    static Ledger ledger;
    return runDeck(forgetfulDeck({"Bodies/punch/Mesh/Cells={" + cells + ", 4}",
                                  "Bodies/foundation/Mesh/Cells={" + std::to_string(2 * std::stoi(cells)) + ", 4}"}),
                   withForgetful(), Comm::single(), ledger, silentLog(), std::move(previous));
  };
  ndframe::Run first = runAfter({}, "4", 1.0);
  EXPECT_EQ(first.failure, "");
  ndframe::Run same = runAfter(handOn(first), "6", 1.0);
  EXPECT_EQ(same.failure, "");
  EXPECT_EQ(same.summary.errors->energyBracket->certificates, 2);
  const ndframe::Run other = runAfter(handOn(same), "5", 3.0);
  EXPECT_THAT(other.failure, HasSubstr("contradict each other"));
  EXPECT_FALSE(other.summary.errors->guaranteed);
}

TEST(ContradictingCertificates, OfTwoCasesOfAStudyAreBothWithdrawn)
{
  const TemporaryFolder folder;
  DeckList deck = forgetfulList({"Output/Directory=" + folder.file("."), "Output/Exodus=false"});
  Diagnostics diagnostics;
  addAxis(deck, "Bodies/punch/Mesh/Cells={4, 4}; {6, 4} && Bodies/foundation/Mesh/Cells={8, 4}; {12, 4}", diagnostics);
  const Study study = expandStudy(deck, "punch.xml", makeDeckSpec(withForgetful()), diagnostics);
  diagnostics.throwIfAny();
  for (const double change : {0.0, 1.0}) {
    forgetfulValue = 1.0;
    perModel = change;
    const Comm comm = Comm::single();
    bool computed = false;
    const ExitCode code = StudyRunner(study, "punch.xml", withForgetful(), comm, silentLog()).run(computed);
    perModel = 0.0;
    EXPECT_EQ(code, change == 0.0 ? ExitCode::Right : ExitCode::NotConverged);
    std::istringstream table(contentsOf(folder.file("punch.study.csv")));
    std::string line;
    std::getline(table, line);
    for (const char* name : {"1,", "2,"}) {
      std::getline(table, line);
      EXPECT_EQ(line.rfind(name, 0), 0u) << line;
      EXPECT_EQ(line.find("case 1 and case 2 contradict each other") != std::string::npos, change != 0.0) << line;
    }
  }
}

TEST(OtherScenes, HaveRecordsOfTheirOwn)
{
  Ledger ledger;
  Reusable reusable;
  for (const char* setting : {"Title=a", "Bodies/punch/Loads/press/Value=3", "Bodies/punch/Material/Young Modulus=7",
                              "Interfaces/contact/Gap=0.1", "Bodies/punch/Mesh/Upper={1, 2}"})
  {
    ndframe::Run run = runDeck(punch().set("Coupling/Type=Monolithic").set(setting).params(), components(),
                               Comm::single(), ledger, silentLog(), std::move(reusable));
    EXPECT_EQ(run.failure, "") << setting;
    EXPECT_EQ(run.summary.errors->energyBracket->certificates, 1) << setting;
    reusable = handOn(run);
  }
}
