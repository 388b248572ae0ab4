// The levels of solids in contact: what they begin with, how exact they are, and what their bounds are worth.

#include <numeric>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carried_solution.hpp"
#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A plate that lifts at its far corner, by conjugate gradients on all levels.
Scene plate(const std::vector<const char*>& settings = {})
{
  Scene scene("contact-loss-3d");
  scene.set("Accuracy/Target=0.06").set("Linear Solver/Type=Multigrid").set("Coupling/Type=Monolithic");
  for (const char* setting : settings)
    scene.set(setting);
  return scene;
}

const std::vector<LevelSummary>& levelsOf(const Outcome& outcome)
{
  return outcome.run.summary.accuracy->levels;
}

void expectSameLevels(const Outcome& found, const Outcome& expected, double tolerance)
{
  ASSERT_EQ(levelsOf(found).size(), levelsOf(expected).size());
  for (std::size_t i = 0; i < levelsOf(found).size(); ++i) {
    const LevelSummary &one = levelsOf(found)[i], &other = levelsOf(expected)[i];
    EXPECT_EQ(one.dofs, other.dofs);
    EXPECT_EQ(one.doubt, "");
    EXPECT_NEAR(one.bound / other.bound, 1.0, tolerance);
  }
}

std::int64_t count(const Outcome& outcome, const std::vector<std::string>& names)
{
  std::int64_t sum = 0;
  for (const std::string& name : names)
    sum += outcome.ledger->counted(name);
  return sum;
}

} // namespace

TEST(LevelStart, ChangesNothingButTheWork)
{
  for (const char* target : {"Accuracy/Target=0.06", "Accuracy/Target=0.03"}) {
    const auto carried = plate({target}).run(), cold = plate({target, "Accuracy/Transfer/Type=None"}).run();
    expectSameLevels(carried, cold, 1e-4);
    EXPECT_EQ(statuses(carried.run), statuses(cold.run)) << target;
    EXPECT_LE(count(carried, {"status passes", "vertex passes"}), count(cold, {"status passes", "vertex passes"}));
    EXPECT_LE(count(carried, {"Krylov iterations", "vertex iterations"}),
              count(cold, {"Krylov iterations", "vertex iterations"}));
    EXPECT_GT(carried.ledger->counted("vertex passes"), 0) << "of the first level, of which nothing is known";
    EXPECT_LT(carried.ledger->counted("vertex passes"), cold.ledger->counted("vertex passes")) << target;
  }
}

/// Another mesh would cost as much again as all before.
TEST(Levels, ThatNarrowlyMissTheTargetTakeMoreSteps)
{
  const auto usual = plate({"Accuracy/Target=0.3"}).run();
  const double bound = levelsOf(usual).front().relative;
  ASSERT_LT(bound, 0.3);
  for (const double share : {0.997, 0.8}) {
    const std::string target = fmt::format("Accuracy/Target={:.6f}", share * bound);
    const auto outcome = plate({target.c_str()}).run();
    EXPECT_EQ(levelsOf(outcome).size(), share > 0.9 ? 1 : 2) << target;
    EXPECT_LE(levelsOf(outcome).back().relative, share * bound);
    EXPECT_EQ(levelsOf(outcome).back().doubt, "");
    const double first = levelsOf(outcome).front().relative / bound;
    EXPECT_TRUE(share > 0.9 ? first < share : std::abs(first - 1.0) < 1e-4) << first;
  }
}

/// The nearer the start, and the less exact the end, the fewer iterations.
TEST(LevelStart, NearTheAnswerSavesIterations)
{
  auto outcome = plate({"Accuracy/Target=0.12"}).run();
  assembleAgain(outcome.run.condensed, outcome.run.model, *outcome.ledger); // the certificate gave it back
  const InterfaceSystem& system = outcome.run.condensed.interface;
  const auto coupling = components().couplings.build(plate().params().sub("Coupling"));
  const InterfaceState& answer = outcome.run.solved.coupling.state;
  const auto iterations = [&](double wrong, Exactness exactness) {
    CouplingStart start;
    start.closed = answer.closed;
    start.fields = answer.fields;
    start.exactness = exactness;
    for (NodalField& field : start.fields)
      for (double& value : field)
        value *= 1.0 + wrong;
    const auto before = outcome.ledger->counted("Krylov iterations");
    const auto result = coupling->solve(
        system, [](const SweepRecord&, const InterfaceState&) {}, *outcome.ledger, start);
    EXPECT_EQ(result.state.closed, answer.closed);
    const double allowed = exactness == Exactness::Full ? 1e-7 : 1e-4;
    EXPECT_LT(relativeDifference(result.state.tractionDirichlet, answer.tractionDirichlet), allowed) << wrong;
    return outcome.ledger->counted("Krylov iterations") - before;
  };
  EXPECT_LE(iterations(0.0, Exactness::Full), 1);
  const auto near = iterations(1e-6, Exactness::Full), far = iterations(-1.0, Exactness::Full);
  EXPECT_LT(near, 0.7 * double(far));
  EXPECT_LT(iterations(-1.0, Exactness::Rough), 0.9 * double(far));
}

TEST(LevelStart, LeavesTheBoundsThatFactorsGive)
{
  const auto carried = plate().run(), factored = plate({"Linear Solver/Type=Cholmod"}).run();
  expectSameLevels(carried, factored, 1e-3);
  EXPECT_NEAR(carried.run.summary.energy / factored.run.summary.energy, 1.0, 1e-9);
  EXPECT_EQ(statuses(carried.run), statuses(factored.run));
}

/// Whether it was meant to be the last one or a limit makes it so.
TEST(LevelStart, TheLastLevelIsAsExactAsTheDeckSays)
{
  for (const char* end : {"Accuracy/Maximum Levels=3", "Accuracy/Target=0.06", "Accuracy/Target=0.2"}) {
    const auto outcome = plate({end}).run();
    EXPECT_LT(outcome.run.summary.residuals.equilibrium, 1e-8) << end;
    EXPECT_LT(outcome.run.summary.residuals.penetration, 1e-8) << end;
    EXPECT_TRUE(outcome.run.summary.errors->guaranteed) << end << outcome.run.summary.errors->reason;
  }
}

TEST(LevelStart, OfASolutionOnItsOwnMeshIsItself)
{
  for (const char* how : {"Linear Solver/Type=Multigrid", "Bodies/lower/Mesh/Cells={5, 5, 3}"}) { // the latter is cut
    const auto outcome = plate({"Accuracy/Target=0.5", how}).run();
    const ndframe::Run& run = outcome.run;
    std::vector<std::vector<int>> same;
    for (const int body : run.model.elasticBodies()) {
      same.emplace_back(std::size_t(run.model.bodies[std::size_t(body)].uncut().numCells()));
      std::iota(same.back().begin(), same.back().end(), 0);
    }
    const auto fields = CarriedSolution(run).onto(run, same, Comm::single());
    const auto& expected = run.solved.coupling.state.fields;
    ASSERT_EQ(fields.size(), expected.size());
    for (std::size_t b = 0; b < fields.size(); ++b)
      EXPECT_LT(relativeDifference(fields[b], expected[b]), 1e-12) << how;
  }
}
