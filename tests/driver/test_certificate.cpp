// What the certificate of a run must satisfy: no bound where there is no error, the paper's identity, gaps.

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "driver/certificate_numbers.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

constexpr const char* projected = "Error Estimation/Interface Traction/Type=Projected";

struct Way
{
  std::vector<std::string> settings;
};

void PrintTo(const Way& way, std::ostream* out)
{
  for (const auto& setting : way.settings)
    *out << setting << ", ";
}

Scene withAll(Scene scene, const std::vector<std::string>& settings)
{
  for (const auto& setting : settings)
    scene.set(setting);
  return scene;
}

/// The ways to find a traction and a stress, for displacements of an order.
std::vector<Way> recoveries(int order)
{
  std::vector<Way> all;
  for (const int degree : {order, order + 1}) {
    const std::string ofDegree = fmt::format("Error Estimation/Recovery/Degree={}", degree);
    all.push_back({{ofDegree}});
    all.push_back({{ofDegree, "Error Estimation/Recovery/Sweeps=1"}});
    all.push_back({{ofDegree, projected}});
    all.push_back({{ofDegree, projected, "Error Estimation/Mode=Paper"}});
    all.push_back({{"Error Estimation/Recovery/Type=Element", ofDegree, projected}});
  }
  for (auto& way : all)
    way.settings.push_back(fmt::format("Discretization/Order={}", order));
  return all;
}

std::vector<Way> allRecoveries()
{
  auto all = recoveries(1), quadratic = recoveries(2);
  all.insert(all.end(), quadratic.begin(), quadratic.end());
  return all;
}

class EveryRecovery : public testing::TestWithParam<Way>
{};

class PaperMode : public testing::TestWithParam<Way>
{};

double square(double x)
{
  return x * x;
}

} // namespace

/// Uniform compression is exact on every mesh: every estimator says so, and there is no error to divide by.
TEST_P(EveryRecovery, FindsNoErrorInThePatch)
{
  Scene scene = withAll(smallScene("patch").rotate(30.0).set("Coupling/Type=Monolithic"), GetParam().settings);
  scene.changeAll("Estimators", [](std::string names) { return names.insert(1, "Reference, "); });
  scene.set("Error Estimation/Reference/Refinements=1").set("Error Estimation/Check Equilibrium=true");
  const auto outcome = scene.run();
  const ErrorSummary& errors = errorsOf(outcome);
  const double norm = std::sqrt(outcome.run.summary.energy);
  for (const auto& number : energyNorms(errors)) {
    // The contact term is the root of what round-off leaves of the jump, also inside sums.
    const bool hasContact = number.name.find("contact") != std::string::npos ||
                            number.name.find("absolute") != std::string::npos || number.name == "mean_stress";
    EXPECT_LT(number.value, (hasContact ? 1e-8 : 1e-10) * norm) << number.name;
  }
  EXPECT_EQ(energyNorms(errors).size(), 19U);
  EXPECT_LT(errors.reference->displacement, 1e-10 * norm);
  EXPECT_FALSE(errors.reference->effectivity);
  EXPECT_FALSE(errors.reference->meanStressEffectivity);
  EXPECT_LT(*errors.equilibrium, 1e-12);
  EXPECT_EQ(errors.guaranteed, errors.mode == "Strict") << errors.reason;
  EXPECT_EQ(errors.advice, "");
}

INSTANTIATE_TEST_SUITE_P(Patch, EveryRecovery, testing::ValuesIn(allRecoveries()));

/// Both stresses are in finite element equilibrium with the same loads and the same traction.
TEST_P(PaperMode, SplitsTheBoundExactly)
{
  for (const char* deck : {"punch", "contact-loss"}) {
    const auto outcome = withAll(smallScene(deck), GetParam().settings)
                             .set("Error Estimation/Mode=Paper")
                             .set("Error Estimation/Interface Traction/Type=Projected")
                             .run();
    const ErrorSummary& errors = errorsOf(outcome);
    EXPECT_NEAR(square(errors.global->absolute) / (square(*errors.splitStress) + square(errors.algorithm->absolute)),
                1.0, 1e-12)
        << deck;
    EXPECT_GT(errors.algorithm->absolute, 0.05 * errors.global->absolute) << deck;
    EXPECT_FALSE(errors.guaranteed) << deck;
    EXPECT_EQ(errors.reason, "Mode is Paper") << deck;
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, PaperMode,
                         testing::Values(Way{{}}, Way{{"Discretization/Order=1"}},
                                         Way{{"Error Estimation/Recovery/Degree=3"}},
                                         Way{{"Error Estimation/Recovery/Sweeps=1"}},
                                         Way{{"Error Estimation/Recovery/Type=Element"}},
                                         Way{{"Error Estimation/Interface Traction/Mean=Updated"}},
                                         Way{{"Interfaces/contact/Gap=0.01*x^2"}}));

/// What the indicator's stress shows is reported beside it.
TEST(CheckEquilibrium, JudgesTheBoundByItsOwnStressOnly)
{
  const auto outcome = smallScene("punch").set("Error Estimation/Check Equilibrium=true").run();
  const ErrorSummary& errors = errorsOf(outcome);
  ASSERT_TRUE(errors.equilibrium && errors.equilibriumDiscretization);
  EXPECT_LT(*errors.equilibrium, 1e-12);
  EXPECT_TRUE(errors.guaranteed) << errors.reason;
  const auto alone = smallScene("punch")
                         .set("Error Estimation/Check Equilibrium=true")
                         .set("Error Estimation/Estimators={Global}")
                         .run();
  EXPECT_DOUBLE_EQ(*errorsOf(alone).equilibrium, *errors.equilibrium);
  EXPECT_FALSE(errorsOf(alone).equilibriumDiscretization);
}

TEST(Split, NeedsNoOtherEstimatorAndComesWithTheIterationsPart)
{
  const auto all = smallScene("punch").run();
  const auto alone = smallScene("punch").set("Error Estimation/Estimators={Split}").run();
  EXPECT_FALSE(errorsOf(alone).global);
  EXPECT_DOUBLE_EQ(*errorsOf(alone).splitStress, *errorsOf(all).splitStress);
  EXPECT_DOUBLE_EQ(errorsOf(alone).algorithm->absolute, errorsOf(all).algorithm->absolute);
}

/// The optimal traction is one of those that the projected one competes with.
TEST(Bound, IsSmallerWithTheOptimalTractionAndWithSweeps)
{
  for (const char* deck : {"punch", "contact-loss"}) {
    const auto boundWith = [&](const std::vector<std::string>& settings) {
      return errorsOf(withAll(smallScene(deck), settings).set("Coupling/Type=Monolithic").run()).global->absolute;
    };
    const double nearest = boundWith({projected}), optimal = boundWith({});
    const double one = boundWith({"Error Estimation/Recovery/Sweeps=1"});
    EXPECT_LT(optimal, nearest) << deck;
    EXPECT_LT(one, optimal) << deck;
    EXPECT_LT(boundWith({"Error Estimation/Recovery/Sweeps=2"}), one) << deck;
  }
}

/// A converged solution: the estimator of the iteration is the distance that the traction is responsible for, and with
/// full contact nothing else.
TEST(Traction, IsNearerInEnergyThanTheProjectionWhereThatMovesIt)
{
  const auto scene = smallScene("punch")
                         .set("Bodies/foundation/Material/Young Modulus=0.01")
                         .set("Coupling/Type=Monolithic")
                         .set("Error Estimation/Estimators={Global, Algorithm, Reference}")
                         .set("Error Estimation/Reference/Refinements=2");
  const auto moved = Scene(scene).run(), nearest = Scene(scene).set(projected).run();
  EXPECT_GT(moved.ledger->counted("traction steps"), 0);
  EXPECT_EQ(nearest.ledger->counted("traction steps"), 0);
  EXPECT_LT(errorsOf(moved).algorithm->absolute, 0.9 * errorsOf(nearest).algorithm->absolute);
  EXPECT_LT(errorsOf(moved).global->absolute, 0.9 * errorsOf(nearest).global->absolute);
  EXPECT_TRUE(errorsOf(moved).guaranteed) << errorsOf(moved).reason;
  EXPECT_GE(errorsOf(moved).global->absolute, errorsOf(moved).reference->displacement);
  const auto alone = Scene(scene).set("Error Estimation/Estimators={Algorithm}").run();
  EXPECT_DOUBLE_EQ(errorsOf(alone).algorithm->absolute, errorsOf(moved).algorithm->absolute);
}

/// A body that only contact holds follows a constant gap as a rigid body.
TEST(Gap, ThatIsConstantLeavesTheBoundOfAFloatingBodyAlone)
{
  const auto closed = smallScene("punch").run();
  for (const char* gap : {"0.3", "1e-3"})
    expectSameErrors(errorsOf(smallScene("punch").set(std::string("Interfaces/contact/Gap=") + gap).run()),
                     errorsOf(closed), 1e-9);
}

TEST(Gap, OfAnyShapeHasABoundAboveTheError)
{
  for (const char* gap : {"0.3 * x^2", "0.1 * (1 - cos(2 * x))", "0.05 * abs(x - 0.37)"})
    for (const char* order : {"1", "2"}) {
      const auto outcome = smallScene("punch")
                               .set(std::string("Interfaces/contact/Gap=") + gap)
                               .set(std::string("Discretization/Order=") + order)
                               .set("Error Estimation/Estimators={Global, Reference}")
                               .set("Error Estimation/Reference/Refinements=2")
                               .run();
      const ErrorSummary& errors = errorsOf(outcome);
      EXPECT_GT(*errors.reference->effectivity, 1.0) << gap << ", order " << order;
      EXPECT_LT(*errors.reference->effectivity, 3.0) << gap << ", order " << order;
      EXPECT_GT(*errors.reference->meanStressEffectivity, 1.0 - 1e-6) << gap << ", order " << order;
    }
}

/// The tractions make up for what the forces lack.
TEST(Guarantee, IsKeptWithForcesOutOfBalance)
{
  const auto outcome = smallScene("punch")
                           .set("Linear Solver/Type=Krylov")
                           .set("Linear Solver/Preconditioner/Type=Ifpack2")
                           .set("Linear Solver/Tolerance=1e-4")
                           .set("Error Estimation/Estimators={Global, Reference}")
                           .set("Error Estimation/Check Equilibrium=true")
                           .set("Error Estimation/Reference/Refinements=1")
                           .run();
  EXPECT_GT(outcome.run.summary.residuals.equilibrium, 1e-9);
  EXPECT_TRUE(errorsOf(outcome).guaranteed) << errorsOf(outcome).reason;
  EXPECT_LT(*errorsOf(outcome).equilibrium, 1e-11);
  EXPECT_GT(*errorsOf(outcome).reference->effectivity, 1.0);
}
