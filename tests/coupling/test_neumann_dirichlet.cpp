#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A stranger to ndframe: full steps first, half steps later.
class FullThenHalf final : public RelaxationController
{
public:
  void start() override { sweep_ = 0; }
  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) override
  {
    const double theta = ++sweep_ == 1 ? 1.0 : 0.5;
    return {relax(dirichlet, neumann, theta), theta, "own"};
  }
  RelaxationMemory memory() const override { return {{double(sweep_)}}; }
  bool recall(const RelaxationMemory& memory) override
  {
    sweep_ = int(memory.at(0).at(0));
    return true;
  }

private:
  int sweep_ = 0;
};

/// Two blocks side by side on one foundation, the first with a gap.
InterfaceSystem twoBlocks()
{
  InterfaceSystem system = emptySystem(7);
  for (std::size_t i = 0; i < 3; ++i)
    system.gap[i] = 0.05;
  system.bodies.push_back(makeBody({0, 1, 2}, true, softChain(3), {0.2, 0.5, 0.9}, true));
  system.bodies.push_back(makeBody({6, 5, 4, 3}, true, mildStiffness(4, 3, 1.0), {-0.3, 0.5, 0.6, 0.4}));
  system.bodies.push_back(makeBody({0, 1, 2, 3, 4, 5, 6}, false, mildStiffness(7, 4, 2.0), Vector(7, 0.1)));
  return system;
}

bool isPartial(const InterfaceState& state)
{
  const auto closed = std::count(state.closed.begin(), state.closed.end(), char(1));
  return closed > 0 && closed < std::ptrdiff_t(state.closed.size());
}

} // namespace

TEST(NeumannDirichlet, PatchFollowsItsClosedForm)
{
  const auto result = run(*neumannDirichlet(1e-8), patchSystem());
  for (const auto& record : result.history) {
    const double p = record.sweep;
    EXPECT_NEAR(record.epsTau, std::pow(2.0, 1.0 - p) / (1.0 - std::pow(2.0, -p)), 1e-14);
    EXPECT_NEAR(record.forceDirichlet, -5.0, 1e-13);
    EXPECT_NEAR(record.forceNeumann, -5.0 * (1.0 - std::pow(2.0, 1.0 - p)), 1e-13);
    EXPECT_EQ(record.theta, 0.5);
    EXPECT_EQ(record.closed, 6);
    EXPECT_EQ(record.open, 0);
  }
}

TEST(NeumannDirichlet, PatchStopsAfterTheSweepsOfItsClosedForm)
{
  const std::vector<std::pair<double, std::size_t>> sweeps = {{0.2, 4},   {0.1, 5},   {1e-2, 8},
                                                              {1e-3, 11}, {1e-4, 15}, {1e-8, 28}};
  for (const auto& [tolerance, expected] : sweeps) {
    const auto result = run(*neumannDirichlet(tolerance), patchSystem());
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.history.size(), expected) << "tolerance " << tolerance;
  }
}

TEST(NeumannDirichlet, BalancedStartEndsThePatchAfterOneSweep)
{
  const auto result = run(*neumannDirichlet(1e-8, text("Initial Traction", "Balanced")), patchSystem());
  EXPECT_TRUE(result.converged);
  ASSERT_EQ(result.history.size(), 1u);
  for (const double traction : result.state.tractionNeumann)
    EXPECT_NEAR(traction, -1.0, 1e-14);
}

TEST(NeumannDirichlet, BalancedStartCarriesTheResultant)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto result = run(*neumannDirichlet(1e-8, text("Initial Traction", "Balanced")), randomSystem(seed, true));
    EXPECT_NEAR(result.history.front().forceNeumann, result.history.front().forceDirichlet, 1e-12);
  }
}

TEST(NeumannDirichlet, BalancedStartIsZeroWhereSupportsHoldEveryBody)
{
  const auto result = run(*neumannDirichlet(1e-8, text("Initial Traction", "Balanced")), randomSystem(1, false));
  EXPECT_EQ(result.history.front().forceNeumann, 0.0);
}

TEST(NeumannDirichlet, OneFactorPerBodyWhateverTheNumberOfSweeps)
{
  Ledger ledger;
  run(*neumannDirichlet(1e-8), patchSystem(), ledger);
  EXPECT_EQ(ledger.counted("sweeps"), 28);
  EXPECT_EQ(ledger.counted("Neumann solves"), 28);
  EXPECT_EQ(ledger.counted("interface factorisations"), 2);
}

TEST(NeumannDirichlet, ConvergesToTheMonolithicSolution)
{
  int partial = 0;
  for (const bool floats : {false, true})
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(testing::Message() << (floats ? "floating" : "held") << ", seed " << seed);
      const auto system = randomSystem(seed, floats);
      const auto result = run(*neumannDirichlet(1e-12), system);
      EXPECT_TRUE(result.converged) << result.reason;
      expectSameState(result.state, run(*makeCoupling(text("Type", "Monolithic")), system).state, 1e-11);
      partial += isPartial(result.state);
    }
  EXPECT_GE(partial, 20) << "contact is hardly ever lost: choose other seeds";
}

TEST(NeumannDirichlet, AitkenAndConstantMeetInTheSameSolution)
{
  std::size_t constant = 0, aitken = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto system = randomSystem(seed, seed % 2 == 1);
    const auto a = run(*neumannDirichlet(1e-12, relaxation("Constant", "Theta", 0.5)), system);
    const auto b = run(*neumannDirichlet(1e-12, relaxation("Aitken", "Initial Theta", 0.5)), system);
    EXPECT_TRUE(b.converged) << b.reason;
    expectSameState(b.state, a.state, 1e-11);
    constant += a.history.size();
    aitken += b.history.size();
  }
  EXPECT_LT(aitken, constant);
}

TEST(NeumannDirichlet, TwoDirichletBodiesOnOneNeumannBody)
{
  const auto system = twoBlocks();
  const auto result = run(*neumannDirichlet(1e-12), system);
  EXPECT_TRUE(result.converged) << result.reason;
  expectEquilibrium(system, result.state);
  expectSameState(result.state, run(*makeCoupling(text("Type", "Monolithic")), system).state, 1e-11);
}

TEST(NeumannDirichlet, FinalStatePairsEachBodyWithTheTractionItWasSolvedWith)
{
  // Stopped early, the two tractions differ; each body is in equilibrium with its own.
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto system = randomSystem(seed, seed % 2 == 1);
    const auto result = run(*neumannDirichlet(0.1), system);
    EXPECT_GT(result.history.back().epsTau, 1e-6);
    expectEquilibrium(system, result.state);
    expectComplementarity(system, result.state);
  }
}

TEST(NeumannDirichlet, UnitsChangeNeitherStatusesNorSweeps)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto system = randomSystem(seed, seed % 2 == 1);
    const auto scaled = inOtherUnits(system, 1e9, 1e-3);
    for (const auto& method : {relaxation("Constant", "Theta", 0.5), relaxation("Aitken", "Initial Theta", 0.5)}) {
      const auto plain = run(*neumannDirichlet(1e-6, method), system);
      const auto other = run(*neumannDirichlet(1e-6, method), scaled);
      EXPECT_EQ(other.state.closed, plain.state.closed);
      EXPECT_EQ(other.history.size(), plain.history.size());
    }
  }
}

TEST(NeumannDirichlet, NodesWithAPrescribedDisplacementCarryNoForce)
{
  InterfaceSystem system = emptySystem(4);
  system.nodeOfUnknown = {1, 2, 3};
  system.gap = ofUnknowns({0.0, 0.0, 0.0});
  system.bodies.push_back(makeBody({0, 1, 2}, true, mildStiffness(3, 1, 0.5), {1.0, 1.0, 1.0}));
  system.bodies.push_back(makeBody({0, 1, 2}, false, mildStiffness(3, 2, 1.0), Vector(3, 0.0)));
  const auto result = run(*neumannDirichlet(1e-12), system);
  EXPECT_TRUE(result.converged);
  expectEquilibrium(system, result.state);
  EXPECT_NEAR(system.C->apply(result.state.tractionDirichlet)[0], 0.0, 1e-14);
}

TEST(NeumannDirichlet, ObserverSeesEverySweep)
{
  Ledger ledger;
  std::vector<int> sweeps;
  InterfaceValues lastTraction;
  const auto result = neumannDirichlet(0.1)->solve(
      patchSystem(),
      [&](const SweepRecord& record, const InterfaceState& state) {
        sweeps.push_back(record.sweep);
        lastTraction = state.tractionNeumann;
      },
      ledger);
  EXPECT_EQ(sweeps, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(lastTraction, result.state.tractionNeumann);
}

TEST(NeumannDirichlet, UsesAControllerThatItDoesNotKnow)
{
  relaxations().add("Full Then Half", "Registered by this test.", {},
                    [](const Params&) { return std::make_unique<FullThenHalf>(); });
  const auto result = run(*neumannDirichlet(1e-8, list("Relaxation", text("Type", "Full Then Half"))), patchSystem());
  // The full step gives Lambda_neu = Lambda_dir at once: the second sweep finds nothing to do.
  ASSERT_EQ(result.history.size(), 2u);
  EXPECT_EQ(result.history[0].theta, 1.0);
  EXPECT_EQ(result.history[1].theta, 0.5);
  EXPECT_EQ(result.history[0].note, "own");
}
