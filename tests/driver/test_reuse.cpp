// Runs that hand on to each other compute again only what the deck changes, with the answers of separate runs.

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"
#include "ndframe/base/log.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// Runs that hand on to each other, as a study's cases do.
class Sequence
{
public:
  Run run(const Scene& scene)
  {
    ledger_.restart();
    return runDeck(scene.params(), components(), Comm::single(), ledger_, silentLog(), std::move(reusable_));
  }
  /// Runs and keeps what the next one may use; the answer is left in the summary.
  RunSummary next(const Scene& scene)
  {
    Run done = run(scene);
    keep(done);
    return done.summary;
  }
  void keep(Run& done) { reusable_ = handOn(done); }
  std::int64_t counted(const char* what) const { return ledger_.counted(what); }
  bool timed(const char* stage) const
  {
    for (const auto& s : ledger_.stages())
      if (s.name == stage)
        return true;
    return false;
  }

private:
  Ledger ledger_; // outlives the factors
  Reusable reusable_;
};

Scene coarse()
{
  return Scene("contact-loss").set("Bodies/upper/Mesh/Cells={10, 8}").set("Bodies/lower/Mesh/Cells={20, 14}");
}

/// What a change costs after a run of the unchanged deck.
struct Cost
{
  const char* setting;
  int factorisations, factorsReused, meshesReused, backSolves;
};

void PrintTo(const Cost& cost, std::ostream* out)
{
  *out << cost.setting;
}

class AfterAChange : public testing::TestWithParam<Cost>
{};

} // namespace

TEST_P(AfterAChange, OnlyWhatDependsOnItIsComputedAgain)
{
  Sequence sequence;
  sequence.next(coarse());
  sequence.next(coarse().set(GetParam().setting));
  EXPECT_EQ(sequence.counted("factorisations"), GetParam().factorisations);
  EXPECT_EQ(sequence.counted("factors reused"), GetParam().factorsReused);
  EXPECT_EQ(sequence.counted("meshes reused"), GetParam().meshesReused);
  // A step to the admissible traction nearest in energy takes one of every body.
  EXPECT_EQ(sequence.counted("back-solves"), GetParam().backSolves + 2 * sequence.counted("traction steps"));
}

/// Bit by bit.
TEST_P(AfterAChange, TheAnswerIsThatOfARunOfItsOwn)
{
  const Scene changed = coarse().set(GetParam().setting);
  const auto alone = changed.run();
  Sequence sequence;
  sequence.next(coarse());
  const auto after = sequence.run(changed);
  for (int body = 0; body < 2; ++body)
    EXPECT_EQ(displacement(after, body), displacement(alone.run, body)) << body;
  EXPECT_EQ(traction(after), traction(alone.run));
  EXPECT_EQ(statuses(after), statuses(alone.run));
  EXPECT_EQ(after.summary.energy, alone.run.summary.energy);
  EXPECT_EQ(after.summary.deckJson, alone.run.summary.deckJson);
  EXPECT_EQ(after.solved.coupling.history.size(), alone.run.solved.coupling.history.size());
  EXPECT_EQ(after.failure, alone.run.failure);
}

/// The columns: factorisations, factors reused, meshes reused, back-solves (two recover the interiors).
INSTANTIATE_TEST_SUITE_P(
    Deck, AfterAChange,
    testing::Values(
        Cost{"Coupling/Stopping/Tolerance=1e-6", 0, 2, 2, 2}, //
        Cost{"Coupling/Relaxation/Theta=0.6", 0, 2, 2, 2},    //
        Cost{"Coupling/Type=Monolithic", 0, 2, 2, 2},         //
        Cost{"Output/Exodus=false", 0, 2, 2, 2},              //
        Cost{"Error Estimation/Estimators={Global}", 0, 2, 2, 4}, Cost{"Interfaces/contact/Gap=0.001 * x", 0, 2, 2, 2},
        Cost{"Bodies/upper/Loads/press/Value=2", 0, 2, 2, 3}, Cost{"Bodies/upper/Material/Young Modulus=3", 1, 1, 2, 3},
        Cost{"Bodies/lower/Material/Poisson Ratio=0.2", 1, 1, 2, 3},
        Cost{"Bodies/lower/Supports/ground/Type=Roller", 1, 1, 2, 3},
        Cost{"Bodies/lower/Mesh/Cells={20, 10}", 1, 1, 1, 3}, // the same nodes on the interface
        Cost{"Bodies/lower/Mesh/Pattern=Alternating", 1, 1, 1, 3}, Cost{"Discretization/Order=1", 2, 0, 0, 4}, //
        Cost{"Linear Solver/Type=Mumps", 2, 0, 2, 4}, Cost{"Interface Operator/Type=Condensed", 0, 2, 2, 4}));

TEST(Reuse, ReadsAndAssemblesNothingForAnotherTolerance)
{
  Sequence sequence;
  sequence.next(coarse());
  EXPECT_TRUE(sequence.timed("read"));
  sequence.next(coarse().set("Coupling/Stopping/Tolerance=1e-6"));
  for (const char* stage : {"read", "assemble", "order", "factor", "interface"})
    EXPECT_FALSE(sequence.timed(stage)) << stage;
}

TEST(Reuse, KeepsTheFactorForOtherPrescribedDisplacements)
{
  const auto pressed = [](const char* value) {
    return coarse()
        .set("Bodies/upper/Supports/top/Type=Displacement")
        .set("Bodies/upper/Supports/top/Side=top")
        .set(std::string("Bodies/upper/Supports/top/Y=") + value);
  };
  Sequence sequence;
  sequence.next(pressed("-0.01"));
  const auto after = sequence.run(pressed("-0.02"));
  EXPECT_EQ(sequence.counted("factorisations"), 0);
  EXPECT_EQ(traction(after), traction(pressed("-0.02").run().run));
}

/// Without a gap the solution is homogeneous of degree one in the load.
TEST(Reuse, OfAFactorGivesTwiceTheSolutionForTwiceTheLoad)
{
  Sequence sequence;
  const Scene together = coarse().set("Coupling/Type=Monolithic");
  const double single = sequence.next(together).energy;
  const double twice = sequence.next(Scene(together).set("Bodies/upper/Loads/press/Value=2")).energy;
  EXPECT_NEAR(twice / single, 4.0, 1e-11);
}

/// What a certificate gave back of solids that are solved by iterations is there again for the next run.
TEST(Reuse, OfSolidsWhoseMatricesTheCertificateGaveBack)
{
  const auto solids = [](const char* change) {
    return Scene("contact-loss-3d")
        .set("Bodies/upper/Mesh/Cells={3, 3, 2}")
        .set("Bodies/lower/Mesh/Cells={6, 6, 3}")
        .set("Linear Solver/Type=Multigrid")
        .set("Bodies/lower/Supports/ground/Type=Displacement")
        .set("Bodies/lower/Supports/ground/X=0")
        .set("Bodies/lower/Supports/ground/Y=0")
        .set("Bodies/lower/Supports/ground/Z=0.01 * x")
        .set(change);
  };
  for (const char* change : {"Bodies/upper/Loads/press/Value=2", "Bodies/lower/Supports/ground/Z=0.02 * x",
                             "Coupling/Stopping/Tolerance=1e-6", "Bodies/lower/Material/Young Modulus=3"})
  {
    Sequence sequence;
    auto first = sequence.run(solids("Output/Exodus=false"));
    ASSERT_TRUE(first.certificate);
    for (const BodySystem& system : first.condensed.systems)
      EXPECT_TRUE(system.K.values.empty());
    sequence.keep(first);
    const RunSummary after = sequence.next(solids(change)), alone = solids(change).run().run.summary;
    EXPECT_NEAR(after.energy / alone.energy, 1.0, 1e-8) << change;
    EXPECT_NEAR(after.errors->global->absolute / alone.errors->global->absolute, 1.0, 1e-6) << change;
    EXPECT_LT(after.residuals.equilibrium, 1e-7) << change;
  }
}

TEST(Reuse, OfAMeshFileEndsWhenTheFileChanges)
{
  const TemporaryFolder folder;
  const std::string mesh = folder.file("foundation.msh");
  std::filesystem::copy(std::string(NDFRAME_DECKS) + "/meshes/punch-foundation-2.2.msh", mesh);
  const Scene scene = Scene("gmsh-msh2").set("Bodies/foundation/Mesh/File=" + mesh);
  Sequence sequence;
  sequence.next(scene);
  sequence.next(scene);
  EXPECT_EQ(sequence.counted("meshes reused"), 2);
  std::filesystem::last_write_time(mesh, std::filesystem::last_write_time(mesh) + std::chrono::seconds(2));
  sequence.next(scene);
  EXPECT_EQ(sequence.counted("meshes reused"), 1);
  EXPECT_EQ(sequence.counted("factorisations"), 1);
}

/// Whatever it is refused for: sides that are not there, a name that the summary does not hold.
TEST(Reuse, GoesOnAfterADeckThatIsRefused)
{
  for (const char* mistake : {"Bodies/upper/Loads/press/Side=roof", "Expect/mine/Quantity=energi"}) {
    Sequence sequence;
    sequence.next(coarse());
    Scene refused = coarse().set(mistake);
    if (std::string(mistake).find("Expect") == 0)
      refused.set("Expect/mine/Value=1").set("Expect/mine/Tolerance=1");
    EXPECT_THROW(sequence.next(refused), InputError);
    const Scene again = coarse().set("Coupling/Stopping/Tolerance=1e-6");
    const auto after = sequence.run(again);
    EXPECT_EQ(sequence.counted("factorisations"), 0) << mistake;
    EXPECT_EQ(sequence.counted("factors reused"), 2) << mistake;
    EXPECT_EQ(sequence.counted("meshes reused"), 2) << mistake;
    EXPECT_EQ(traction(after), traction(again.run().run));
  }
}

namespace
{

/// The coarse scene with a reference solution.
Scene compared()
{
  return coarse()
      .set("Error Estimation/Estimators={Global, Reference}")
      .set("Error Estimation/Reference/Refinements=1");
}

/// Whether the run kept the reference; its errors must be those of a run of its own.
bool keepsTheReference(Sequence& sequence, const Scene& scene)
{
  const auto after = *sequence.next(scene).errors, alone = *scene.run().run.summary.errors;
  EXPECT_NEAR(after.reference->displacement / alone.reference->displacement, 1.0, 1e-8);
  EXPECT_NEAR(*after.reference->stress / *alone.reference->stress, 1.0, 1e-8);
  EXPECT_EQ(after.reference->dofs, alone.reference->dofs);
  return sequence.counted("references reused") == 1;
}

} // namespace

TEST(Reference, IsKeptWhileTheSceneIsTheSame)
{
  Sequence sequence;
  EXPECT_FALSE(keepsTheReference(sequence, compared()));
  EXPECT_TRUE(keepsTheReference(sequence, compared().set("Coupling/Stopping/Tolerance=1e-6")));
  sequence.next(coarse()); // asks for none
  EXPECT_TRUE(keepsTheReference(sequence, compared().set("Error Estimation/Recovery/Degree=3")));
}

TEST(Reference, IsSolvedAgainForAnotherScene)
{
  for (const char* change : {"Bodies/upper/Loads/press/Value=2", "Bodies/lower/Material/Young Modulus=3",
                             "Interfaces/contact/Gap=0.001 * x", "Error Estimation/Reference/Refinements=2"})
  {
    Sequence sequence;
    sequence.next(compared());
    EXPECT_FALSE(keepsTheReference(sequence, compared().set(change))) << change;
  }
}

TEST(Reference, IsSolvedAgainWhenTheBodiesExchangeTheirRoles)
{
  const Scene stiff = compared().set("Bodies/upper/Material/Young Modulus=1000").set("Coupling/Relaxation/Type=Aitken");
  Sequence sequence;
  sequence.next(stiff);
  const Scene automatic = Scene(stiff).set("Coupling/Dirichlet Body=Automatic");
  ASSERT_TRUE(automatic.run().run.summary.coupling->roles.front().exchanged);
  EXPECT_FALSE(keepsTheReference(sequence, automatic));
}
