// Different ways to the same discrete solution must meet in it.

#include <gtest/gtest.h>

#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

struct Tolerances
{
  double displacement, traction;
};

void expectSameSolution(const Run& a, const Run& b, Tolerances tolerance)
{
  for (int body = 0; body < int(b.model.bodies.size()); ++body)
    EXPECT_LT(relativeDifference(displacement(a, body), displacement(b, body)), tolerance.displacement) << body;
  EXPECT_LT(relativeDifference(traction(a), traction(b)), tolerance.traction);
  EXPECT_EQ(statuses(a), statuses(b));
  EXPECT_NEAR(a.summary.energy / b.summary.energy, 1.0, tolerance.displacement);
}

constexpr Tolerances sharp{1e-10, 1e-9};

/// A shipped deck on a mesh that is coarse enough for solvers that iterate within iterations.
struct Coarse
{
  const char* deck;
  std::vector<const char*> cells;
};

void PrintTo(const Coarse& coarse, std::ostream* out)
{
  *out << coarse.deck;
}

class TwoBodies : public testing::TestWithParam<Coarse>
{
protected:
  static Scene coarse()
  {
    Scene scene(GetParam().deck);
    for (const char* cells : GetParam().cells)
      scene.set(cells);
    return scene;
  }
  static Scene iterated() { return coarse().set("Coupling/Stopping/Tolerance=1e-12"); }
  static Scene together() { return coarse().set("Coupling/Type=Monolithic"); }
};

} // namespace

TEST_P(TwoBodies, AreBroughtByTheIterationToTheMonolithicSolution)
{
  const auto reference = together().run();
  for (const char* relaxation : {"Coupling/Relaxation/Type=Constant", "Coupling/Relaxation/Type=Aitken"}) {
    const auto outcome = iterated().set(relaxation).run();
    EXPECT_TRUE(outcome.run.solved.coupling.converged) << relaxation;
    expectSameSolution(outcome.run, reference.run, sharp);
  }
}

TEST_P(TwoBodies, AreBroughtThereFasterByAitken)
{
  EXPECT_LT(iterated().set("Coupling/Relaxation/Type=Aitken").run().run.solved.coupling.history.size(),
            iterated().run().run.solved.coupling.history.size());
}

TEST_P(TwoBodies, DoNotDependOnTheStartingTraction)
{
  const auto zero = iterated().run(), balanced = iterated().set("Coupling/Initial Traction=Balanced").run();
  expectSameSolution(balanced.run, zero.run, sharp);
}

TEST_P(TwoBodies, DoNotDependOnTheInterfaceOperator)
{
  for (const auto& scene : {iterated(), together()}) {
    const auto condensed = Scene(scene).set("Interface Operator/Type=Condensed").run();
    const auto matrixFree = Scene(scene).set("Interface Operator/Type=Matrix Free").run();
    expectSameSolution(matrixFree.run, condensed.run, sharp);
  }
}

/// At 1e-12 round-off decides which sweep is the last, at 1e-10 it does not.
TEST_P(TwoBodies, TakeAsManySweepsWithEveryInterfaceOperator)
{
  const Scene scene = coarse().set("Coupling/Stopping/Tolerance=1e-10");
  EXPECT_EQ(Scene(scene).set("Interface Operator/Type=Condensed").run().run.solved.coupling.history.size(),
            Scene(scene).set("Interface Operator/Type=Matrix Free").run().run.solved.coupling.history.size());
}

TEST_P(TwoBodies, DoNotDependOnTheLinearSolver)
{
  const auto cholmod = together().set("Linear Solver/Type=Cholmod").run();
  expectSameSolution(together().set("Linear Solver/Type=Mumps").run().run, cholmod.run, sharp);
  const auto krylov = together().set("Linear Solver/Type=Krylov").set("Linear Solver/Tolerance=1e-11").run();
  // A residual is amplified by the matrix's condition.
  expectSameSolution(krylov.run, cholmod.run, {1e-8, 1e-6});
}

TEST_P(TwoBodies, AreInEquilibriumAndDoNotPullOnEachOther)
{
  for (const auto& scene : {iterated(), together()}) {
    const auto residuals = scene.run().run.summary.residuals;
    EXPECT_LT(residuals.equilibrium, 1e-11);
    EXPECT_LT(residuals.complementarity, 1e-10);
    EXPECT_LT(residuals.penetration, 1e-10);
    EXPECT_LT(residuals.tension, 1e-10);
  }
}

TEST(ContactLoss, HasOpenAndClosedNodes)
{
  const auto contact = Scene("contact-loss").set("Coupling/Type=Monolithic").run().run.summary.interfaces.front();
  EXPECT_GT(contact.closedNodes, 0);
  EXPECT_LT(contact.closedNodes, contact.nodes);
}

INSTANTIATE_TEST_SUITE_P(
    Decks, TwoBodies,
    testing::Values(Coarse{"punch", {"Bodies/punch/Mesh/Cells={8, 8}", "Bodies/foundation/Mesh/Cells={16, 8}"}},
                    Coarse{"contact-loss", {"Bodies/upper/Mesh/Cells={10, 8}", "Bodies/lower/Mesh/Cells={20, 20}"}},
                    Coarse{"hertz", {"Bodies/cylinder/Mesh/Cells={16, 8}", "Bodies/block/Mesh/Cells={16, 8}"}}));

namespace
{

/// The punch on boxes of few cells, refined.
Scene refinedPunch(int ofPunch, int ofFoundation, bool isCertified = false)
{
  Scene scene("punch");
  scene.set("Bodies/punch/Mesh/Cells={4, 4}").set("Bodies/foundation/Mesh/Cells={8, 4}");
  scene.set("Bodies/punch/Mesh/Refine=" + std::to_string(ofPunch));
  scene.set("Bodies/foundation/Mesh/Refine=" + std::to_string(ofFoundation)).set("Coupling/Type=Monolithic");
  return isCertified ? scene.set("Error Estimation/Estimators={Global}") : scene;
}

} // namespace

TEST(RefineParameter, SolvesAsTheFinerBoxesDo)
{
  Scene fine("punch");
  fine.set("Bodies/punch/Mesh/Cells={16, 16}").set("Bodies/foundation/Mesh/Cells={32, 16}");
  const auto refined = refinedPunch(2, 2).run(), drawn = fine.set("Coupling/Type=Monolithic").run();
  EXPECT_EQ(refined.run.model.totalDofs(), drawn.run.model.totalDofs());
  EXPECT_NEAR(refined.run.summary.energy / drawn.run.summary.energy, 1.0, 1e-11);
  EXPECT_FALSE(refined.run.model.interfaces.front().map); // the sides go on matching
}

TEST(RefineParameter, OfOneBodyHasTheSidesCut)
{
  const auto even = refinedPunch(1, 1, true).run(), uneven = refinedPunch(2, 1, true).run();
  EXPECT_TRUE(uneven.run.model.interfaces.front().map);
  EXPECT_TRUE(uneven.run.summary.errors->guaranteed);
  // Brackets of one exact energy.
  EXPECT_LE(uneven.run.energy.lower(), even.run.energy.upper());
  EXPECT_LE(even.run.energy.lower(), uneven.run.energy.upper());
}

TEST(RefineParameter, OfOneSolidCutsTheOther)
{
  Scene scene("contact-loss-3d");
  scene.set("Bodies/upper/Mesh/Cells={3, 3, 2}").set("Bodies/lower/Mesh/Cells={6, 6, 2}");
  const double coarse = Scene(scene).run().run.summary.energy;
  const double fine =
      Scene(scene).set("Bodies/upper/Mesh/Refine=1").set("Bodies/lower/Mesh/Refine=1").run().run.summary.energy;
  const double mixed = scene.set("Bodies/lower/Mesh/Refine=1").run().run.summary.energy;
  EXPECT_GT(mixed, coarse);
  EXPECT_LT(mixed, fine);
}

TEST(RefineParameter, OfSolidsOnlyLowersTheEnergyThatIsLeft)
{
  Scene scene("contact-loss-3d");
  scene.set("Bodies/upper/Mesh/Cells={3, 3, 2}")
      .set("Bodies/lower/Mesh/Cells={6, 6, 2}")
      .set("Coupling/Type=Monolithic");
  const double coarse = Scene(scene).run().run.summary.energy;
  const double fine =
      scene.set("Bodies/upper/Mesh/Refine=1").set("Bodies/lower/Mesh/Refine=1").run().run.summary.energy;
  EXPECT_GT(fine, coarse); // of all finer meshes, as the spaces are nested and only forces act
  EXPECT_LT(fine, 1.1 * coarse);
}

TEST(RefineParameter, LeavesWhatIsExact)
{
  for (const char* deck : {"patch", "beam-3d"}) {
    Scene scene(deck);
    const double energy = Scene(scene).run().run.summary.energy;
    for (const Params& body : scene.params().sub("Bodies").subs())
      scene.set("Bodies/" + body.name() + "/Mesh/Refine=1");
    EXPECT_NEAR(scene.run().run.summary.energy / energy, 1.0, 1e-11) << deck;
  }
}

TEST(RefineParameter, OfABoxIsTheMostThatATargetBeginsWith)
{
  Scene refined = refinedPunch(2, 2, true).set("Accuracy/Target=0.1"), fine("punch");
  fine.set("Bodies/punch/Mesh/Cells={16, 16}").set("Bodies/foundation/Mesh/Cells={32, 16}");
  fine.set("Coupling/Type=Monolithic").set("Error Estimation/Estimators={Global}").set("Accuracy/Target=0.1");
  const auto levels = [](const Scene& scene) { return scene.run().run.summary.accuracy->levels; };
  const auto first = levels(refined), second = levels(fine);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t l = 0; l < first.size(); ++l)
    EXPECT_EQ(first[l].bound, second[l].bound);
}
