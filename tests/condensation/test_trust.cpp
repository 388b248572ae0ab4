#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "driver/scene.hpp"
#include "ndframe/condensation/trust.hpp"
#include "ndframe/run/summarize.hpp"

namespace ndframe::test
{
namespace
{

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

RunSummary converged()
{
  RunSummary summary;
  summary.coupling.emplace();
  summary.coupling->converged = true;
  return summary;
}

/// The reason for one residual of this size.
std::string reasonFor(double ResidualSummary::*residual, double size)
{
  auto summary = converged();
  summary.residuals.*residual = size;
  return distrust(summary);
}

} // namespace

TEST(Trust, AConvergedStateWithoutResidualsIsTrusted)
{
  EXPECT_THAT(distrust(converged()), IsEmpty());
  EXPECT_THAT(distrust(RunSummary{}), IsEmpty()) << "a single body has no coupling";
}

TEST(Trust, EveryResidualIsLimited)
{
  const ResidualLimits limits;
  const struct
  {
    double ResidualSummary::*residual;
    double limit;
    const char* says;
  } cases[] = {{&ResidualSummary::equilibrium, limits.equilibrium, "out of balance by"},
               {&ResidualSummary::penetration, limits.contact, "penetrate by"},
               {&ResidualSummary::tension, limits.contact, "contact pulls with"},
               {&ResidualSummary::complementarity, limits.contact, "presses across an opening"}};
  for (const auto& c : cases) {
    EXPECT_THAT(reasonFor(c.residual, 0.99 * c.limit), IsEmpty());
    EXPECT_THAT(reasonFor(c.residual, 1.01 * c.limit), HasSubstr(c.says));
    EXPECT_THAT(reasonFor(c.residual, std::numeric_limits<double>::quiet_NaN()), HasSubstr(c.says));
  }
}

TEST(Trust, ANumberThatIsNoneIsNotTrusted)
{
  auto summary = converged();
  summary.energy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(distrust(summary), "the result is not a number");
}

TEST(Trust, AnIterationThatDidNotConvergeSaysItsOwnReason)
{
  auto summary = converged();
  summary.coupling->converged = false;
  summary.coupling->reason = "too few sweeps";
  summary.residuals.equilibrium = 1.0;
  EXPECT_EQ(distrust(summary), "too few sweeps");
}

TEST(Trust, ContactHoldsToRoundOffHoweverEarlyTheIterationStops)
{
  for (const char* deck : {"punch", "contact-loss"}) {
    const auto residuals = Scene(deck).set("Coupling/Stopping/Tolerance=0.5").run().run.summary.residuals;
    EXPECT_LT(residuals.penetration, 1e-12) << deck;
    EXPECT_LT(residuals.complementarity, 1e-12) << deck;
    EXPECT_LT(residuals.tension, 1e-12) << deck;
  }
}

TEST(Trust, BodiesThatOnlyMoveRigidlyAreInBalance)
{
  Scene scene("patch");
  scene.set("Bodies/upper/Loads/press/Value=0").set("Interfaces/contact/Gap=0.25");
  for (const char* entry : {"Type=Displacement", "Side=top", "Y=-0.25"})
    scene.set(std::string("Bodies/upper/Supports/let down to touch/") + entry);
  for (const char* coupling : {"Monolithic", "Neumann-Dirichlet"}) {
    const auto outcome = scene.set(std::string("Coupling/Type=") + coupling).run();
    EXPECT_THAT(outcome.run.failure, IsEmpty()) << coupling;
    EXPECT_LT(outcome.run.summary.energy, 1e-28) << coupling;
  }
}

/// The punch's height follows from nothing: every answer would be round-off, a different one on every mesh.
TEST(Trust, ContactThatNothingPressesIsUndecided)
{
  for (const int cells : {4, 5, 7, 12})
    for (const char* coupling : {"Monolithic", "Neumann-Dirichlet"}) {
      const auto meshed = [&] {
        return Scene("punch")
            .set(fmt::format("Bodies/punch/Mesh/Cells={{{0}, {0}}}", cells))
            .set(fmt::format("Bodies/foundation/Mesh/Cells={{{}, {}}}", 2 * cells, cells))
            .set(std::string("Coupling/Type=") + coupling);
      };
      const auto reason = AllOf(AnyOf(HasSubstr("contact is undecided: nothing presses \"punch\""),
                                      HasSubstr("does not press the bodies together")),
                                HasSubstr("translation along y of punch"));
      EXPECT_THAT(meshed().set("Bodies/punch/Loads/press/Side=right").run().run.failure, reason) << cells << coupling;
      for (const char* gap : {"1", "1e-6"})
        EXPECT_THAT(meshed()
                        .set("Bodies/punch/Loads/press/Value=0")
                        .set(std::string("Interfaces/contact/Gap=") + gap)
                        .run()
                        .run.failure,
                    reason)
            << cells << coupling << gap;
    }
}

TEST(Trust, ALoadThatIsSmallBesideOthersDecidesContact)
{
  Scene scene("punch");
  scene.set("Bodies/punch/Loads/press/Value=1e-6");
  for (const char* entry : {"Type=Pressure", "Side=bottom", "Value=1"})
    scene.set(std::string("Bodies/foundation/Loads/on the support/") + entry);
  EXPECT_THAT(scene.run().run.failure, IsEmpty());
}

/// Thin bodies: the solution is right, but the stiffness that the certificate has to solve with is not definite.
TEST(Trust, AStiffnessThatIsLostInRoundOffLeavesNoCertificate)
{
  const auto run = Scene("punch")
                       .set("Bodies/punch/Mesh/Cells={5, 5}")
                       .set("Bodies/foundation/Mesh/Cells={10, 5}")
                       .set("Bodies/punch/Mesh/Upper={1.0, 1e-4}")
                       .set("Bodies/foundation/Mesh/Lower={0.0, -1e-4}")
                       .set("Error Estimation/Estimators={Global}")
                       .run()
                       .run;
  EXPECT_TRUE(run.solved.coupling.converged);
  EXPECT_FALSE(run.certificate);
  EXPECT_THAT(run.failure, HasSubstr("no certificate: a body's stiffness on the interface is lost in round-off"));
}

TEST(NumberRange, LoadsThatUnderOrOverflowAreRefused)
{
  for (const char* load : {"1e-300", "1e-60", "1e60", "1e300"}) {
    Scene scene("punch");
    scene.set(std::string("Bodies/punch/Loads/press/Value=") + load);
    EXPECT_THAT(complaintOf(scene), HasSubstr("leave the range of floating-point numbers")) << load;
  }
}

TEST(NumberRange, SizesAndModuliAreRefusedByName)
{
  EXPECT_THAT(complaintOf(Scene("punch").set("Bodies/punch/Material/Young Modulus=1e-80")),
              HasSubstr("Bodies/punch/Material: the elastic moduli reach"));
  EXPECT_THAT(complaintOf(Scene("punch").set("Interfaces/contact/Gap=1e60")),
              HasSubstr("--set: Interfaces/contact: the values of Gap reach"));
  EXPECT_THAT(complaintOf(Scene("punch").changeUnits(1e-70, 1.0)), HasSubstr("Bodies/punch/Mesh: the coordinates"));
}

TEST(NumberRange, NoLoadAndSmallOrLargeUnitsAreFine)
{
  EXPECT_THAT(Scene("punch").set("Bodies/punch/Loads/press/Value=0").run().run.failure, IsEmpty());
  for (const double unit : {1e-12, 1e12})
    EXPECT_THAT(Scene("punch").changeUnits(unit, 1.0 / unit).run().run.failure, IsEmpty());
}

} // namespace ndframe::test
