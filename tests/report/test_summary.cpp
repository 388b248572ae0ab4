#include "ndframe/report/summary_text.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "ndframe/base/diagnostics.hpp"
#include "report/sample_summaries.hpp"

using namespace ndframe;
using ndframe::test::contactSummary;
using ndframe::test::singleBodySummary;
using Json = nlohmann::ordered_json;

TEST(Summary, NumbersReadBackExactly)
{
  auto summary = singleBodySummary();
  for (const double value : {1.0 / 3.0, 1e-300, -1.7976931348623157e308, 5e-324, 0.1, 123456789.0}) {
    summary.energy = value;
    EXPECT_EQ(Json::parse(toJson(summary))["energy"].get<double>(), value);
  }
  EXPECT_EQ(Json::parse(toJson(summary))["ledger"]["peak_bytes"].get<std::int64_t>(), 6'000'000'000);
}

TEST(Summary, NotANumberAndInfinityAreNull)
{
  auto summary = singleBodySummary();
  summary.energy = std::numeric_limits<double>::quiet_NaN();
  summary.totalSeconds = -std::numeric_limits<double>::infinity();
  const auto json = Json::parse(toJson(summary));
  EXPECT_TRUE(json["energy"].is_null());
  EXPECT_TRUE(json["ledger"]["total_seconds"].is_null());
}

TEST(Summary, HoldsTheDeckAsAnObject)
{
  const auto json = Json::parse(toJson(singleBodySummary()));
  EXPECT_EQ(json["deck"]["Bodies"]["beam"]["Mesh"]["Cells"], Json({4, 1, 1}));
  EXPECT_EQ(json["deck"], Json::parse(singleBodySummary().deckJson));
}

TEST(Summary, RefusesADeckThatIsNotAnObject)
{
  auto summary = singleBodySummary();
  for (const auto* deck : {"", "{", "[1]", "3"}) {
    summary.deckJson = deck;
    EXPECT_THROW(toJson(summary), InternalError) << deck;
  }
}

TEST(Summary, OfNoSolutionKeepsTheSceneAndTheFinishedSweeps)
{
  auto summary = contactSummary();
  summary.solved = false;
  const auto json = Json::parse(toJson(summary));
  EXPECT_TRUE(json["energy"].is_null() && json["bodies"][1]["energy"].is_null());
  EXPECT_TRUE(json["interfaces"][0]["end_points"].is_null() && json["residuals"]["tension"].is_null());
  EXPECT_EQ(json["interfaces"][0]["nodes"], 61);
  EXPECT_EQ(json["coupling"]["sweeps"], 2);
  EXPECT_EQ(ndframe::summaryValue(summary, "interfaces/contact/contact_force"), std::nullopt);
}

TEST(Summary, CouplingIsNullWithoutInterfaces)
{
  EXPECT_TRUE(Json::parse(toJson(singleBodySummary()))["coupling"].is_null());
  EXPECT_EQ(Json::parse(toJson(contactSummary()))["coupling"]["history"].size(), 2U);
}

TEST(Summary, ErrorsAreNullWithoutACertificate)
{
  EXPECT_TRUE(Json::parse(toJson(singleBodySummary()))["errors"].is_null());
}

TEST(Summary, AccuracyIsNullWithoutATarget)
{
  EXPECT_TRUE(Json::parse(toJson(singleBodySummary()))["accuracy"].is_null());
}

TEST(Summary, AccuracySumsItsLevelsUp)
{
  const auto accuracy = Json::parse(toJson(contactSummary()))["accuracy"];
  EXPECT_EQ(accuracy["number_of_levels"], 2);
  EXPECT_EQ(accuracy["sweeps"], 3);
  EXPECT_EQ(accuracy["dofs"], 910);
  EXPECT_EQ(accuracy["total_dofs"], 958);
  EXPECT_TRUE(accuracy["levels"][1]["dofs_to_target"].is_null());
}

TEST(LevelTable, HasOneRowALevelAndNoNumberThatIsNotKnown)
{
  auto levels = contactSummary().accuracy->levels;
  levels[0].worstBody = "a, b";
  levels[0].doubt = "round-off";
  levels[1].energy = {-0.75, -0.5};
  EXPECT_EQ(levelsCsv(levels),
            "level,dofs,elements,worst_shape,sweeps,bound,relative,mesh,iteration,largest_body,largest_x,"
            "largest_y,dofs_to_target,seconds,energy_lower,energy_upper,guaranteed\n"
            "1,48,6,0.875,2,0.25,0.20000000000000001,0.23999999999999999,0.070000000000000007,\"a, b\","
            "0.5,-0.25,832,0.010000,,,0\n"
            "2,910,201,0.5,1,0.0625,0.050000000000000003,0.059999999999999998,0.01,foundation,"
            "1.5,0.75,,0.040000,-0.75,-0.5,1\n");
}

TEST(LevelTable, HasThreeCoordinatesInSpace)
{
  auto levels = contactSummary().accuracy->levels;
  for (auto& level : levels)
    level.worstPoint.push_back(0.125);
  const std::string table = levelsCsv(levels);
  EXPECT_THAT(table, testing::HasSubstr(",largest_body,largest_x,largest_y,largest_z,dofs_to_target,"));
  EXPECT_THAT(table, testing::HasSubstr(",foundation,1.5,0.75,0.125,,"));
}

TEST(Summary, ErrorsThatWereNotComputedAreNull)
{
  auto summary = contactSummary();
  summary.errors = ErrorSummary{};
  const auto errors = Json::parse(toJson(summary))["errors"];
  for (const auto* key : {"global", "algorithm", "discretization", "split_stress", "mean_stress", "zienkiewicz_zhu",
                          "residual", "equilibrium", "equilibrium_discretization", "reference", "energy_bracket"})
    EXPECT_TRUE(errors[key].is_null()) << key;
}

TEST(Summary, SurvivesNamesThatAreNotUtf8)
{
  auto summary = singleBodySummary();
  summary.bodies[0].name = "b\xe9ton \"1\"\n";
  EXPECT_EQ(Json::parse(toJson(summary))["bodies"][0]["name"], "b\uFFFDton \"1\"\n");
}

TEST(SummaryValue, FindsListEntriesByName)
{
  const auto summary = contactSummary();
  EXPECT_EQ(summaryValue(summary, "energy"), 1.5);
  EXPECT_EQ(summaryValue(summary, "bodies/foundation/energy"), 1.0);
  EXPECT_EQ(summaryValue(summary, "interfaces/contact/contact_force"), 1.0);
  EXPECT_EQ(summaryValue(summary, "ledger/counts/factorisations"), 1.0);
  EXPECT_EQ(summaryValue(summary, "ledger/stages/factor/seconds"), 0.5);
  EXPECT_EQ(summaryValue(summary, "deck/Bodies/beam/Mesh/Cells/0"), 4.0);
}

TEST(SummaryValue, FindsListEntriesByIndex)
{
  const auto summary = contactSummary();
  EXPECT_EQ(summaryValue(summary, "bodies/1/dofs"), 3842.0);
  EXPECT_EQ(summaryValue(summary, "coupling/history/0/eps_tau"), 2.0);
  EXPECT_EQ(summaryValue(summary, "interfaces/contact/end_points/1/0"), 0.957);
}

TEST(SummaryValue, PrefersANameToAnIndex)
{
  auto summary = contactSummary();
  summary.bodies[0].name = "1";
  EXPECT_EQ(summaryValue(summary, "bodies/1/dofs"), 1986.0);
}

TEST(SummaryValue, CountsBooleansAsNumbers)
{
  auto summary = contactSummary();
  EXPECT_EQ(summaryValue(summary, "coupling/converged"), 1.0);
  summary.coupling->converged = false;
  EXPECT_EQ(summaryValue(summary, "coupling/converged"), 0.0);
}

TEST(SummaryValue, FindsTheNumbersOfTheCertificate)
{
  auto summary = contactSummary();
  EXPECT_EQ(summaryValue(summary, "errors/global/absolute"), 0.0625);
  EXPECT_EQ(summaryValue(summary, "errors/global/contact"), 0.01);
  EXPECT_EQ(summaryValue(summary, "errors/algorithm/relative"), 0.04);
  EXPECT_EQ(summaryValue(summary, "errors/mean_stress/relative"), 0.025);
  EXPECT_EQ(summaryValue(summary, "errors/reference/effectivity"), 1.04);
  EXPECT_EQ(summaryValue(summary, "errors/global/guaranteed"), 0.0);
  summary.errors->guaranteed = true;
  EXPECT_EQ(summaryValue(summary, "errors/global/guaranteed"), 1.0);
  summary.errors->discretization.reset();
  EXPECT_EQ(summaryValue(summary, "errors/discretization/absolute"), std::nullopt);
}

TEST(SummaryValue, IsEmptyWhereThereIsNoNumber)
{
  const auto summary = contactSummary();
  for (const auto* path : {"", "/", "energy/", "energy/x", "bodies", "bodies/2/dofs", "bodies/-1/dofs", "bodies//dofs",
                           "bodies/anvil/dofs", "bodies/99999999999999999999/dofs", "bodies/punch/name",
                           "coupling/history/1/eps_tau", "Energy"})
    EXPECT_EQ(summaryValue(summary, path), std::nullopt) << path;
  EXPECT_EQ(summaryValue(singleBodySummary(), "coupling/sweeps"), std::nullopt);
}
