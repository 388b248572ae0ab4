#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

constexpr unsigned numSeeds = 12;

/// Calls `check(system)` for random scenes of all kinds, with a trace that says which.
template <class Check>
void forAllScenes(const Check& check)
{
  for (unsigned seed = 0; seed < numSeeds; ++seed) {
    const auto scenes = randomScenes(seed);
    for (std::size_t kind = 0; kind < scenes.size(); ++kind) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", kind " << kind);
      check(scenes[kind], seed);
    }
  }
}

CouplingResult run(const Coupling& coupling, const InterfaceSystem& system, const CouplingStart& start)
{
  Ledger ledger;
  return test::run(coupling, system, ledger, start);
}

InterfaceState together(const InterfaceSystem& system)
{
  return test::run(*makeCoupling(text("Type", "Monolithic")), system).state;
}

CouplingStart startFrom(const InterfaceState& state)
{
  return {state.tractionDirichlet, state.closed, 0.0};
}

/// Tractions of either sign, a thousand times too large, and statuses by chance.
CouplingStart garbage(const InterfaceSystem& system, unsigned seed)
{
  CouplingStart start{atInterface(randomNumbers(system.C->size(), seed + 100)), {}, 0.0};
  for (double& traction : start.traction)
    traction *= 1e3;
  for (const double number : randomNumbers(system.size(), seed + 200))
    start.closed.push_back(number > 0.0);
  return start;
}

double sum(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

TEST(CouplingStart, FromTheAnswerTakesOneSweepAndKeepsIt)
{
  forAllScenes([](const InterfaceSystem& system, unsigned) {
    const auto answer = together(system);
    const auto result = run(*neumannDirichlet(1e-9), system, startFrom(answer));
    EXPECT_TRUE(result.converged) << result.reason;
    EXPECT_EQ(result.history.size(), 1u);
    EXPECT_EQ(result.history.front().statusChanges, 0);
    EXPECT_EQ(result.history.front().statusPasses, 1);
    expectSameState(result.state, answer, 1e-9);
  });
}

TEST(CouplingStart, FromGarbageMeetsTheSameAnswer)
{
  int partial = 0;
  forAllScenes([&](const InterfaceSystem& system, unsigned seed) {
    const auto answer = together(system);
    const auto result = run(*neumannDirichlet(1e-12), system, garbage(system, seed));
    EXPECT_TRUE(result.converged) << result.reason;
    expectSameState(result.state, answer, 1e-10);
    partial += std::count(answer.closed.begin(), answer.closed.end(), char(0)) > 0;
  });
  EXPECT_GE(partial, 20) << "contact is hardly ever lost: choose other seeds";
}

TEST(CouplingStart, EveryBodyIsInEquilibriumAfterTheFirstSweepFromGarbage)
{
  forAllScenes([](const InterfaceSystem& system, unsigned seed) {
    const auto result = run(*neumannDirichlet(1e-14, {}, 1), system, garbage(system, seed));
    expectEquilibrium(system, result.state, 1e-9); // forces are a thousand
  });
}

TEST(CouplingStart, GivenTractionIsCorrectedToCarryTheLoadsOfFloatingBodies)
{
  for (unsigned seed = 0; seed < numSeeds; ++seed) {
    const auto floats = randomSystem(seed, true);
    const auto first = run(*neumannDirichlet(0.1, {}, 1), floats, garbage(floats, seed)).state;
    EXPECT_NEAR(sum(first.forceNeumann), -sum(floats.bodies[0].g), 1e-10);
  }
}

TEST(CouplingStart, TractionThatCarriesTheLoadsIsTakenAsItIs)
{
  forAllScenes([](const InterfaceSystem& system, unsigned seed) {
    const auto somewhere = run(*neumannDirichlet(1e-14, text("Initial Traction", "Balanced"), 2), system).state;
    const auto first =
        run(*neumannDirichlet(1e-14, {}, 1), system, {somewhere.tractionDirichlet, garbage(system, seed).closed, {}});
    const double scale = largestEntry(somewhere.tractionDirichlet);
    for (std::size_t i = 0; i < somewhere.tractionDirichlet.size(); ++i)
      EXPECT_NEAR(first.state.tractionNeumann[i], somewhere.tractionDirichlet[i], 1e-13 * scale);
  });
}

TEST(CouplingStart, TractionBetweenBodiesThatStayApartDiesAway)
{
  // eps_tau remains 2 then: one side is zero. The loads say when the other one is.
  auto system = randomSystem(2, false);
  std::fill(system.gap.begin(), system.gap.end(), 100.0);
  const auto answer = together(system);
  ASSERT_EQ(std::count(answer.closed.begin(), answer.closed.end(), char(1)), 0);
  for (const double goal : {0.0, 1e-6}) {
    auto start = garbage(system, 3);
    start.iterationError = goal;
    const auto result = run(*neumannDirichlet(0.01, {}, 200), system, start);
    EXPECT_TRUE(result.converged) << result.reason;
    EXPECT_EQ(result.state.closed, answer.closed);
    EXPECT_LT(largestEntry(result.state.tractionNeumann), goal == 0.0 ? 1e-14 : 1e-5);
  }
}

TEST(CouplingStart, NodesWithAPrescribedDisplacementCarryNoForce)
{
  InterfaceSystem system = emptySystem(4);
  system.nodeOfUnknown = {1, 2, 3};
  system.gap = ofUnknowns({0.0, 0.0, 0.0});
  system.bodies.push_back(makeBody({0, 1, 2}, true, mildStiffness(3, 1, 0.5), {1.0, 1.0, 1.0}));
  system.bodies.push_back(makeBody({0, 1, 2}, false, mildStiffness(3, 2, 1.0), Vector(3, 0.0)));
  const InterfaceValues given = atInterface({-5.0, -1.0, -2.0, -3.0});
  const auto first = run(*neumannDirichlet(1e-14, {}, 1), system, {given, {}, {}}).state;
  EXPECT_NEAR(system.C->apply(first.tractionNeumann)[0], 0.0, 1e-14);
  const UnknownValues wanted = system.force(given);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NEAR(first.forceNeumann[i], wanted[i], 1e-14);
}

TEST(CouplingStart, MonolithicUsesTheStatuses)
{
  forAllScenes([](const InterfaceSystem& system, unsigned seed) {
    const auto monolithic = makeCoupling(text("Type", "Monolithic"));
    const auto answer = together(system);
    EXPECT_EQ(run(*monolithic, system, startFrom(answer)).history.front().statusPasses, 1);
    expectSameState(run(*monolithic, system, garbage(system, seed)).state, answer, 1e-10);
  });
}

TEST(CouplingStart, SweepsEndWhenTheIterationsPartIsBelowItsGoal)
{
  forAllScenes([](const InterfaceSystem& system, unsigned) {
    CouplingStart start;
    start.iterationError = 1e-5;
    const auto result = run(*neumannDirichlet(0.999), system, start);
    EXPECT_TRUE(result.converged);
    EXPECT_THAT(result.reason, HasSubstr("< 1e-05 (energy norm)"));
    for (const auto& sweep : result.history)
      EXPECT_EQ(*sweep.iterationError < start.iterationError, sweep.sweep == int(result.history.size()));
  });
}

TEST(CouplingStart, OnlyAMeasuredIterationCostsAFactorAndItsSolves)
{
  const auto scenes = randomScenes(1);
  for (const auto& system : scenes) {
    Ledger plain, again;
    const auto coupling = neumannDirichlet(1e-14, {}, 4);
    const auto result = test::run(*coupling, system, plain);
    test::run(*coupling, system, again, {result.state.tractionNeumann, {}, {}});
    EXPECT_FALSE(result.history.back().iterationError.has_value());
    EXPECT_EQ(plain.counted("Neumann solves"), 4);
    EXPECT_EQ(again.counted("Neumann solves"), 4);
    for (const double goal : {0.0, 1e-30}) { // 0: Tolerance decides all the same
      Ledger measured;
      const auto last = test::run(*coupling, system, measured, {{}, {}, goal}).history.back();
      EXPECT_TRUE(last.iterationError.has_value());
      EXPECT_EQ(measured.counted("Neumann solves"), 8);
      EXPECT_EQ(measured.counted("interface factorisations"), plain.counted("interface factorisations") + 1);
      EXPECT_EQ(measured.counted("status passes"), plain.counted("status passes"));
    }
  }
}
