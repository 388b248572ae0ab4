// The list Error Estimation: what it means, what runs because of it.

#include <gmock/gmock.h>

#include "driver/scene.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/run/plan.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

namespace
{

ErrorOptions optionsOf(Scene scene)
{
  return *readSettings(scene.params()).errors;
}

std::unique_ptr<StressRecovery> recovery(const std::string& type)
{
  Params deck = Scene("punch").set("Error Estimation/Recovery/Type=" + type).params();
  return components().recoveries.build(deck.sub("Error Estimation").sub("Recovery"));
}

Plan planOf(const Scene& scene)
{
  const Params deck = scene.params();
  return Plan(readSettings(deck), *components().linearSolvers.build(deck.sub("Linear Solver")), 1);
}

/// The parts of the certificate that a scene's plan runs.
std::vector<std::string> certificateParts(const Scene& scene)
{
  const Plan plan = planOf(scene);
  std::vector<std::string> parts;
  for (const auto& stage : plan.stages())
    if (const auto& name = stageNames().name(stage.stage); stage.runs && name.rfind("certify ", 0) == 0)
      parts.push_back(name.substr(8));
  return parts;
}

} // namespace

TEST(ErrorEstimation, IsAbsentUnlessTheDeckNamesIt)
{
  EXPECT_FALSE(readSettings(Scene("punch").params()).errors);
  EXPECT_TRUE(readSettings(Scene("punch").set("Error Estimation/Mode=Strict").params()).errors);
}

TEST(ErrorEstimation, EstimatesTheBoundAndItsPartsByDefault)
{
  const auto options = optionsOf(Scene("punch").set("Error Estimation/Mode=Strict"));
  EXPECT_THAT(options.estimators,
              UnorderedElementsAre(Estimator::Global, Estimator::Algorithm, Estimator::Discretization));
  EXPECT_EQ(options.tractionWith(*recovery("Automatic"), 2), TractionType::Optimal);
  EXPECT_EQ(options.tractionWith(*recovery("Automatic"), 3), TractionType::Optimal);
  EXPECT_EQ(options.tractionWith(*recovery("Star"), 3), TractionType::Projected);
  EXPECT_EQ(options.tractionWith(*recovery("Element"), 2), TractionType::Projected);
  EXPECT_EQ(options.tractionMean, TractionMean::Previous);
  EXPECT_EQ(options.refinements, 3);
  EXPECT_EQ(options.maximumDofs, 0);
  EXPECT_TRUE(options.optimises(*recovery("Automatic"), 2));
}

TEST(ErrorEstimation, EstimatesTheBoundAloneWithoutAnInterface)
{
  const auto options = optionsOf(Scene("beam-3d").set("Error Estimation/Mode=Strict"));
  EXPECT_THAT(options.estimators, ElementsAre(Estimator::Global));
  EXPECT_FALSE(options.needsTraction());
  EXPECT_FALSE(options.optimises(*recovery("Automatic"), 2));
  EXPECT_TRUE(options.recoversStress());
}

TEST(ErrorEstimation, OptimisesOnlyTheTractionOfTheBound)
{
  EXPECT_FALSE(optionsOf(Scene("punch").set("Error Estimation/Interface Traction/Type=Projected"))
                   .optimises(*recovery("Automatic"), 2));
  EXPECT_FALSE(optionsOf(Scene("punch").set("Error Estimation/Estimators={Discretization}"))
                   .optimises(*recovery("Automatic"), 2));
}

TEST(Plan, HasOneLineForACertificateThatTheDeckDoesNotAskFor)
{
  EXPECT_FALSE(planOf(Scene("punch")).runs(Stage::Certificate));
  EXPECT_THAT(certificateParts(Scene("punch")), testing::IsEmpty());
  EXPECT_THROW(planOf(Scene("punch")).runs(Stage::CertifyRecovery), InternalError);
}

TEST(Plan, RunsThePartsThatTheEstimatorsNeed)
{
  const auto parts = [](const std::string& estimators, const std::string& deck = "punch") {
    return certificateParts(Scene(deck).set("Error Estimation/Estimators={" + estimators + "}"));
  };
  EXPECT_THAT(parts("Global"), ElementsAre("traction", "fields", "recovery", "estimators"));
  EXPECT_THAT(parts("Global", "beam-3d"), ElementsAre("recovery", "estimators"));
  EXPECT_THAT(parts("Algorithm"), ElementsAre("traction", "fields", "estimators"));
  EXPECT_THAT(parts("Zienkiewicz-Zhu, Residual"), ElementsAre("estimators"));
  EXPECT_THAT(parts("Reference"), ElementsAre("reference"));
  EXPECT_THAT(certificateParts(Scene("punch").set("Error Estimation/Check Equilibrium=true")),
              ElementsAre("traction", "fields", "recovery", "equilibrium", "estimators"));
}
