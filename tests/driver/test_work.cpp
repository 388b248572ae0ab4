// What a run does, and what it does not do: the ledger counts it exactly.

#include <algorithm>
#include <map>

#include <sys/resource.h>

#include <gmock/gmock.h>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "ndframe/base/log.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/run/plan.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

namespace
{

bool isLoaded(const std::string& library)
{
  return contentsOf("/proc/self/maps").find(library) != std::string::npos;
}

/// Page faults of all child processes that have ended: grows with every one.
long faultsOfChildren()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_minflt;
}

/// A scene condensed, for several solutions with the same factors.
struct Condensed
{
  explicit Condensed(const Scene& scene) : deck(scene.params()), model(buildModel(readScene(deck), components()))
  {
    solver = components().linearSolvers.build(deck.sub("Linear Solver"));
    representation = components().interfaceOperators.build(deck.sub("Interface Operator"));
    condensed = condense(model, *solver, *representation, Comm::single(), ledger);
  }
  CouplingResult couple(const std::string& setting)
  {
    const Params other = Scene("punch").set(setting).params();
    return components()
        .couplings.build(other.sub("Coupling"))
        ->solve(
            condensed.interface, [](auto&&...) {}, ledger);
  }

  Ledger ledger;
  Params deck;
  Model model;
  std::unique_ptr<LinearSolver> solver;
  std::unique_ptr<InterfaceOperator> representation;
  CondensedModel condensed;
};

std::string deckName(const testing::TestParamInfo<std::string>& deck)
{
  std::string name = deck.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class ShippedDeck : public testing::TestWithParam<std::string>
{};

} // namespace

TEST_P(ShippedDeck, DoesWhatItsPlanSays)
{
  const bool mpiBefore = mpiIsRunning(), trilinosBefore = isLoaded("trilinos_tpetra");
  const long faultsBefore = faultsOfChildren();
  const auto outcome = Scene(GetParam()).run();
  const Plan& plan = outcome.run.plan;
  for (const auto& stage : outcome.ledger->stages())
    EXPECT_TRUE(plan.runs(stageNames().value(stage.name == "order" ? "factor" : stage.name))) << stage.name;
  const auto always = testing::AnyOf("read", "check", "assemble", "factor", "interface", "couple", "recover",
                                     testing::StartsWith("certify "));
  for (const auto& planned : plan.stages())
    if (const auto& name = stageNames().name(planned.stage); planned.runs && testing::Matches(always)(name)) {
      EXPECT_THAT(outcome.ledger->stages(), testing::Contains(testing::Field(&Ledger::Stage::name, name)));
    }
  // ctest runs every case in a process of its own; in one process only the first user of a library tells something.
  if (!mpiBefore) {
    EXPECT_EQ(mpiIsRunning(), plan.runs(Stage::Mpi));
  }
  if (!trilinosBefore) {
    EXPECT_EQ(isLoaded("trilinos_tpetra"), plan.runs(Stage::Krylov));
  }
  // Gmsh, and the library that reads Exodus files, run in a child process, and without such a mesh there is none.
  EXPECT_FALSE(isLoaded("libgmsh"));
  EXPECT_EQ(faultsOfChildren() > faultsBefore, plan.runs(Stage::Gmsh) || GetParam() == "exodus");
}

TEST_P(ShippedDeck, FactorsEveryBodyOnceWithACertificateToo)
{
  Scene scene(GetParam());
  // A reference is a scene of its own, with factors of its own.
  scene.changeAll("Estimators", [](const std::string&) { return "{Global, Algorithm, Discretization}"; });
  const auto outcome = scene.run();
  const bool isKrylov = GetParam() == "krylov";
  EXPECT_EQ(outcome.ledger->counted("factorisations"), isKrylov ? 0 : int(outcome.run.model.elasticBodies().size()));
}

INSTANTIATE_TEST_SUITE_P(Decks, ShippedDeck, testing::ValuesIn(shippedDecks()), deckName);

TEST(Ledger, CountsTwoFactorisationsHoweverManySweeps)
{
  for (const char* setting : {"Coupling/Stopping/Tolerance=0.1", "Coupling/Stopping/Tolerance=1e-12",
                              "Coupling/Relaxation/Type=Aitken", "Coupling/Type=Monolithic"})
  {
    const auto outcome = Scene("contact-loss").set(setting).run();
    EXPECT_EQ(outcome.ledger->counted("factorisations"), 2) << setting;
    EXPECT_EQ(outcome.ledger->counted("sweeps"), outcome.run.summary.coupling->sweeps) << setting;
    // One right-hand side a body to reduce its load, one to recover its interior.
    EXPECT_EQ(outcome.ledger->counted("back-solves"), 4) << setting;
  }
}

TEST(Ledger, CountsOneBackSolveABodyAndSweepForAllSweeps)
{
  const auto outcome = Scene("contact-loss").set("Output/Steps=All Sweeps").run();
  EXPECT_EQ(outcome.ledger->counted("back-solves"), 2 + 2 * outcome.run.summary.coupling->sweeps);
}

TEST(Ledger, CountsNoFactorisationForASecondTolerance)
{
  Condensed scene(Scene("contact-loss"));
  EXPECT_EQ(scene.ledger.counted("factorisations"), 2);
  const auto backSolves = scene.ledger.counted("back-solves");
  const auto loose = scene.couple("Coupling/Stopping/Tolerance=0.1");
  const auto sharp = scene.couple("Coupling/Stopping/Tolerance=1e-9");
  EXPECT_LT(loose.history.size(), sharp.history.size());
  EXPECT_EQ(scene.ledger.counted("factorisations"), 2);
  EXPECT_EQ(scene.ledger.counted("back-solves"), backSolves);
}

/// A body's Neumann problem is solved by its factor, not by conjugate gradients over products with S: once a sweep.
TEST(Ledger, CountsOneNeumannSolveASweepMatrixFree)
{
  const auto outcome =
      Scene("punch").set("Interface Operator/Type=Matrix Free").set("Coupling/Stopping/Tolerance=1e-3").run();
  const int sweeps = outcome.run.summary.coupling->sweeps;
  EXPECT_GE(sweeps, 12);
  EXPECT_LE(outcome.ledger->counted("back-solves"), 4);
  EXPECT_LE(outcome.ledger->counted("kept solves"), 3 * sweeps);
}

/// Conjugate gradients on the body itself, from what earlier sweeps found.
TEST(Ledger, CountsFewKrylovIterationsMatrixFree)
{
  const auto outcome = Scene("punch").set("Linear Solver/Type=Krylov").set("Coupling/Stopping/Tolerance=1e-3").run();
  EXPECT_GE(outcome.run.summary.coupling->sweeps, 12);
  EXPECT_LE(outcome.ledger->counted("back-solves"), 40);
  EXPECT_LE(outcome.ledger->counted("Krylov iterations"), 400);
}

namespace
{

/// What the certificate adds to the ledger of a scene, but for stresses whose round-off had to be settled: a matter of
/// the machine.
std::map<std::string, std::int64_t> countsAdded(const Scene& scene, const std::vector<std::string>& settings)
{
  Scene certified = scene;
  for (const auto& setting : settings)
    certified.set("Error Estimation/" + setting);
  const auto without = scene.run(), with = certified.run();
  auto added = with.ledger->counts();
  for (const auto& [name, count] : without.ledger->counts())
    added[name] -= count;
  added.erase("settled stresses");
  for (auto count = added.begin(); count != added.end();)
    count = count->second == 0 ? added.erase(count) : std::next(count);
  return added;
}

std::int64_t numPoints(const Scene& scene)
{
  std::int64_t points = 0;
  for (const auto& body : buildModel(readScene(scene.params()), components()).bodies)
    points += body.mesh.numPoints();
  return points;
}

} // namespace

TEST(Ledger, CountsOnePassASweepWhereAllNodesStayClosed)
{
  const auto outcome = Scene("punch").set("Coupling/Stopping/Tolerance=1e-6").run();
  EXPECT_GT(outcome.ledger->counted("sweeps"), 5);
  EXPECT_EQ(outcome.ledger->counted("status passes"), outcome.ledger->counted("sweeps"));
  EXPECT_EQ(outcome.ledger->counted("status changes"), 0);
  EXPECT_EQ(outcome.ledger->counted("interface factorisations"), 2); // of the Neumann body and of the closed set
}

/// A few nodes change in a pass: the factor of the first set serves the others.
TEST(Ledger, CountsOneFactorForAllStatusesOfALongInterface)
{
  const auto outcome = Scene("contact-loss")
                           .set("Coupling/Type=Monolithic")
                           .set("Bodies/upper/Mesh/Cells={200, 4}")
                           .set("Bodies/lower/Mesh/Cells={400, 4}")
                           .run();
  EXPECT_TRUE(outcome.run.failure.empty()) << outcome.run.failure;
  EXPECT_GT(outcome.ledger->counted("status passes"), 3);
  EXPECT_EQ(outcome.ledger->counted("interface factorisations"), 1);
  EXPECT_EQ(outcome.ledger->counted("interface factors moved"), outcome.ledger->counted("status passes") - 1);
}

TEST(Ledger, CountsOnePassForBodiesThatStayApart)
{
  for (const char* coupling : {"Neumann-Dirichlet", "Monolithic"}) {
    Scene scene("contact-loss");
    scene.set(std::string("Coupling/Type=") + coupling).set("Interfaces/contact/Gap=100.0");
    scene.set("Bodies/upper/Supports/symmetry/Type=Clamp").set("Bodies/upper/Supports/symmetry/Side=unloaded");
    const auto outcome = scene.run();
    EXPECT_EQ(outcome.run.solved.coupling.reason, "the bodies do not touch: each is solved by itself");
    EXPECT_TRUE(outcome.run.failure.empty()) << outcome.run.failure;
    EXPECT_EQ(outcome.ledger->counted("sweeps"), 1);
    EXPECT_EQ(outcome.ledger->counted("status passes"), 1);
    EXPECT_EQ(countsAdded(scene, {"Estimators={Global}"}).count("back-solves"), 0U);
  }
}

TEST(Ledger, CountsNothingOfTheInterfaceWithoutOne)
{
  const auto outcome = Scene("beam-3d").run();
  EXPECT_EQ(outcome.ledger->counted("factorisations"), 1);
  EXPECT_EQ(outcome.ledger->counted("back-solves"), 1);
  for (const char* count : {"sweeps", "interface factorisations", "status passes", "status changes", "Neumann solves"})
    EXPECT_EQ(outcome.ledger->counts().count(count), 0U) << count;
  EXPECT_FALSE(outcome.run.summary.coupling);
  EXPECT_TRUE(outcome.run.solved.contact.empty());
  EXPECT_EQ(outcome.run.condensed.interface.C, nullptr);
}

TEST(Ledger, CountsNothingOfTheCertificateWithoutOne)
{
  const auto outcome = Scene("punch").run();
  for (const char* count : {"stars", "star sweeps", "interface stars", "element problems"})
    EXPECT_EQ(outcome.ledger->counts().count(count), 0U) << count;
  for (const auto& stage : outcome.ledger->stages())
    EXPECT_NE(stage.name.rfind("certify", 0), 0U) << stage.name;
  EXPECT_FALSE(outcome.run.certificate);
  EXPECT_FALSE(outcome.run.summary.errors);
}

/// What the bound adds: one star a vertex, whatever the number of fields; the stars of the interface's vertices 3
/// times before and twice after; two back-solves for every step of the traction, which the projection moves where
/// contact ends.
std::vector<std::pair<std::string, std::int64_t>> countsOfBound(const std::string& deck, std::int64_t backSolves)
{
  const bool isLoss = deck == "contact-loss";
  std::vector<std::pair<std::string, std::int64_t>> counts{{"stars", numPoints(Scene(deck))},
                                                           {"back-solves", backSolves + (isLoss ? 4 : 0)},
                                                           {"interface stars", 5 * (isLoss ? 21 : 16)}};
  if (isLoss)
    counts.emplace_back("traction steps", 2);
  return counts;
}

TEST(Ledger, CountsTwoBackSolvesAndOneStarAVertexForTheBound)
{
  for (const char* deck : {"punch", "contact-loss"})
    EXPECT_THAT(countsAdded(Scene(deck), {"Estimators={Global}"}), UnorderedElementsAreArray(countsOfBound(deck, 2)))
        << deck;
}

/// Three fields: the separate problem of the Neumann body is the one that the iteration has solved.
TEST(Ledger, CountsTheSameStarsForAllFields)
{
  for (const char* deck : {"punch", "contact-loss"})
    EXPECT_THAT(countsAdded(Scene(deck), {"Estimators={Global, Algorithm, Discretization, Split}"}),
                UnorderedElementsAreArray(countsOfBound(deck, 3)))
        << deck;
}

/// Every sweep solves every star again, and those of the interface, which are not visited twice before it.
TEST(Ledger, CountsTheStarsOfEverySweep)
{
  EXPECT_THAT(countsAdded(Scene("punch"), {"Estimators={Global}", "Recovery/Sweeps=2"}),
              UnorderedElementsAre(Pair("back-solves", 2), Pair("stars", 3 * numPoints(Scene("punch"))),
                                   Pair("interface stars", 5 * 16), Pair("star sweeps", 2)));
}

TEST(Ledger, CountsElementProblemsInsteadOfStarsForElementEquilibration)
{
  EXPECT_THAT(countsAdded(Scene("punch"), {"Estimators={Global, Discretization}", "Recovery/Type=Element",
                                           "Interface Traction/Type=Projected"}),
              UnorderedElementsAre(Pair("back-solves", 3), Pair("element problems", 2 * (450 + 900))));
}

TEST(Ledger, CountsBodyForcesOnlyWhereThereAreSome)
{
  EXPECT_EQ(Scene("punch").run().ledger->counted("body force integrals"), 0);
  Scene heavy("punch");
  heavy.set("Bodies/punch/Loads/weight/Type=Body Force").set("Bodies/punch/Loads/weight/Y=-1");
  const auto outcome = heavy.run();
  EXPECT_EQ(outcome.ledger->counted("body force integrals"), outcome.run.model.bodies.front().mesh.numCells());
}

TEST(Ledger, CountsOnlyWhatAnEstimatorNeeds)
{
  EXPECT_THAT(countsAdded(Scene("punch"), {"Estimators={Algorithm}"}), UnorderedElementsAre(Pair("back-solves", 2)));
  EXPECT_THAT(countsAdded(Scene("punch"), {"Estimators={Discretization}"}),
              UnorderedElementsAre(Pair("back-solves", 1), Pair("stars", numPoints(Scene("punch")))));
  EXPECT_THAT(countsAdded(Scene("punch"), {"Estimators={Zienkiewicz-Zhu, Residual}"}), IsEmpty());
  // The six shapes of a box's cells. The solution is exact: there is nothing to lower.
  EXPECT_THAT(countsAdded(Scene("beam-3d"), {"Estimators={Global}"}), UnorderedElementsAre(Pair("cell matrices", 6)));
}

TEST(Ledger, CountsTheStepsThatLowerTheBoundOfSolids)
{
  const auto stepsWith = [](const std::vector<std::string>& entries) {
    Scene scene("punch-3d");
    scene.set("Bodies/punch/Mesh/Cells={2, 2, 2}").set("Bodies/foundation/Mesh/Cells={4, 4, 2}");
    for (const std::string& entry : entries)
      scene.set("Error Estimation/Recovery/" + entry);
    return scene.run().ledger->counted("recovery steps");
  };
  const std::int64_t usual = stepsWith({});
  EXPECT_GT(usual, 8);
  EXPECT_LT(usual, 25);
  EXPECT_GT(stepsWith({"Sweeps=2"}), usual);
  EXPECT_EQ(stepsWith({"Type=Global", "Steps=6"}), 6);
  EXPECT_EQ(stepsWith({"Type=Global", "Least Gain=0"}), 100);
}

/// The tractions of a converged iteration that are admissible as they are: u_h is in equilibrium with them already.
TEST(Ledger, CountsNoBackSolveForTheCertificateOfAConvergedPatch)
{
  EXPECT_THAT(countsAdded(Scene("patch").set("Coupling/Type=Monolithic"), {"Estimators={Global, Discretization}"}),
              UnorderedElementsAre(Pair("stars", numPoints(Scene("patch"))), Pair("interface stars", 5 * 5)));
}

TEST(Plan, SkipsWhatTheDeckSwitchesOff)
{
  const auto planOf = [](const Scene& scene, int ranks) {
    const Params deck = scene.params();
    return Plan(readSettings(deck), *components().linearSolvers.build(deck.sub("Linear Solver")), ranks);
  };
  EXPECT_FALSE(planOf(Scene("punch").set("Output/Exodus=false"), 1).runs(Stage::Stress));
  EXPECT_TRUE(planOf(Scene("punch").set("Output/Exodus=false"), 1).runs(Stage::Write));
  EXPECT_FALSE(planOf(Scene("punch").set("Output/Contact Table=false"), 1).runs(Stage::ContactTable));
  EXPECT_FALSE(planOf(Scene("beam-3d"), 1).runs(Stage::ContactTable));
  EXPECT_FALSE(planOf(Scene("punch"), 1).runs(Stage::Mpi));
  EXPECT_TRUE(planOf(Scene("punch"), 2).runs(Stage::Mpi));
}
