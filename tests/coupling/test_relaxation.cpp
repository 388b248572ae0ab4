#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::AllOf;
using testing::HasSubstr;

namespace
{

std::string aitken(double initialTheta = 0.5)
{
  return text("Type", "Aitken") + "<Parameter name=\"Initial Theta\" type=\"double\" value=\"" +
         std::to_string(initialTheta) + "\"/>";
}

std::string constant(const std::string& theta)
{
  return text("Type", "Constant") + "<Parameter name=\"Theta\" type=\"double\" value=\"" + theta + "\"/>";
}

std::string complaint(const std::string& entries)
{
  try {
    makeRelaxation(entries);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

/// The factors of four sweeps on a small linear map, in units where a stress of 1 is `unit`.
Vector factors(RelaxationController& controller, double unit)
{
  InterfaceValues traction = atInterface({0.0, 0.0});
  Vector thetas;
  controller.start();
  for (int sweep = 0; sweep < 4; ++sweep) {
    const InterfaceValues image =
        atInterface({-0.4 * traction[0] + 0.3 * traction[1] - unit, 0.2 * traction[0] - 0.7 * traction[1] - 2 * unit});
    const auto next = controller.next(image, traction);
    thetas.push_back(next.theta);
    traction = next.traction;
  }
  return thetas;
}

} // namespace

TEST(Relaxation, ConstantIsTheFormula)
{
  const auto controller = makeRelaxation(constant("0.25"));
  for (int sweep = 0; sweep < 3; ++sweep) {
    const auto next = controller->next(atInterface({-4.0, 8.0}), atInterface({4.0, 0.0}));
    EXPECT_EQ(next.traction, (Vector{2.0, 2.0}));
    EXPECT_EQ(next.theta, 0.25);
    EXPECT_EQ(next.note, "");
  }
}

TEST(Relaxation, AitkenSolvesAffineFixedPointInTwoSweeps)
{
  // Lambda_dir = a Lambda + b has the fixed point b / (1 - a).
  for (const double a : {-3.0, -0.9, 0.0, 0.4}) {
    const auto controller = makeRelaxation(aitken());
    controller->start();
    double traction = 0.0;
    for (int sweep = 0; sweep < 2; ++sweep)
      traction = controller->next(atInterface({a * traction - 1.0}), atInterface({traction})).traction[0];
    EXPECT_NEAR(traction, -1.0 / (1.0 - a), 1e-14) << a;
  }
}

TEST(Relaxation, AitkenBeginsWithItsInitialThetaInEveryRun)
{
  const auto controller = makeRelaxation(aitken(0.25));
  const Vector first = factors(*controller, 1.0), second = factors(*controller, 1.0);
  EXPECT_EQ(first[0], 0.25);
  EXPECT_NE(first[1], 0.25);
  EXPECT_EQ(first, second);
}

TEST(Relaxation, AitkenIsInvariantUnderUnits)
{
  const auto controller = makeRelaxation(aitken());
  const Vector plain = factors(*controller, 1.0);
  for (const double unit : {1e9, 1e-9}) {
    const Vector scaled = factors(*controller, unit);
    for (std::size_t i = 0; i < plain.size(); ++i)
      EXPECT_NEAR(scaled[i], plain[i], 1e-13);
  }
}

TEST(Relaxation, AitkenRefusesAndReportsFactorsOutOfRange)
{
  // The residuals -1, -0.9 propose theta = 5; then -0.9, -1 a negative one.
  const auto controller = makeRelaxation(aitken());
  controller->start();
  controller->next(atInterface({-1.0}), atInterface({0.0}));
  const auto large = controller->next(atInterface({-0.9}), atInterface({0.0}));
  EXPECT_EQ(large.theta, 0.5);
  EXPECT_EQ(large.note, "theta 5 refused");
  const auto negative = controller->next(atInterface({-1.0}), atInterface({0.0}));
  EXPECT_EQ(negative.theta, 0.5);
  EXPECT_EQ(negative.note, "theta -4.5 refused");
}

TEST(Relaxation, AitkenKeepsItsFactorWhenNothingChanges)
{
  const auto controller = makeRelaxation(aitken(0.75));
  controller->start();
  for (int sweep = 0; sweep < 3; ++sweep)
    EXPECT_EQ(controller->next(atInterface({-1.0}), atInterface({-1.0})).theta, 0.75);
}

TEST(Relaxation, AutomaticHasTheBestThetaOfTheSpectrum)
{
  const auto controller = makeRelaxation(text("Type", "Automatic"));
  ASSERT_TRUE(controller->needsSpectrum());
  const RoleSpectrum held{0.5, 3.5, false, false}, floating{0.5, 3.5, true, false};
  for (const auto& [spectrum, theta] : {std::pair(held, 2.0 / 6.0), std::pair(floating, 2.0 / 5.5)}) {
    controller->startWith(spectrum);
    for (int sweep = 0; sweep < 3; ++sweep)
      EXPECT_NEAR(controller->next(atInterface({-1.0}), atInterface({std::pow(0.5, sweep) - 1.0})).theta, theta,
                  0.05 * theta); // two digits
  }
}

TEST(Relaxation, AutomaticConvergesWhereAnEigenvalueWasUnderestimated)
{
  // Lambda_dir = -mu Lambda - 1 with mu = 10, of which the spectrum knows 0 to 4: 1 - theta (1 + mu) = -2.7.
  const auto controller = makeRelaxation(text("Type", "Automatic"));
  controller->startWith({0.0, 4.0, false, false});
  double traction = 0.0;
  bool noted = false;
  for (int sweep = 0; sweep < 30; ++sweep) {
    const auto next = controller->next(atInterface({-10.0 * traction - 1.0}), atInterface({traction}));
    noted = noted || next.note.find("theta lowered") == 0;
    traction = next.traction[0];
  }
  EXPECT_TRUE(noted);
  EXPECT_NEAR(traction, -1.0 / 11.0, 1e-9);
}

TEST(Relaxation, AutomaticWithoutASpectrumBeginsWithOneHalf)
{
  const auto controller = makeRelaxation(text("Type", "Automatic"));
  controller->startWith({std::nan(""), std::nan(""), false, false});
  EXPECT_EQ(controller->next(atInterface({-1.0}), atInterface({0.0})).theta, 0.5);
}

TEST(Relaxation, FactorsOutOfRangeAreRefused)
{
  for (const char* theta : {"0.0", "2.0", "-0.5", "nan"})
    EXPECT_THAT(complaint(constant(theta)), AllOf(HasSubstr("Theta"), HasSubstr("test.xml:"))) << theta;
  EXPECT_THAT(complaint(constant("2.5")), HasSubstr("(0, 2)"));
  EXPECT_THAT(complaint(aitken(2.0)), AllOf(HasSubstr("Initial Theta"), HasSubstr("(0, 2)")));
}
