// CouplingStart::sweeps: sweeps that go on from kept ones have the bits of those that were not ended.

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A full matrix as a map of tractions, with other residuals in every sweep.
InterfaceValues imageOf(const InterfaceValues& traction)
{
  const std::size_t n = traction.size();
  InterfaceValues image = traction;
  for (std::size_t i = 0; i < n; ++i)
    image[i] = -0.9 * traction[(i + 1) % n] + 0.3 * traction[(i + 3) % n] - 1.0 / double(i + 1);
  return image;
}

std::vector<InterfaceValues> tractions(RelaxationController& controller, InterfaceValues traction, int sweeps)
{
  std::vector<InterfaceValues> all{std::move(traction)};
  for (int sweep = 0; sweep < sweeps; ++sweep)
    all.push_back(controller.next(imageOf(all.back()), all.back()).traction);
  return all;
}

/// The couplings of decks: constant factors, changing ones, mixed sweeps.
std::vector<std::string> waysToRelax()
{
  return {relaxation("Constant", "Theta", 0.4), relaxation("Aitken", "Initial Theta", 0.7),
          list("Relaxation", text("Type", "Automatic"))};
}

void expectSameBits(const CouplingResult& a, const CouplingResult& b)
{
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    EXPECT_EQ(a.history[i].epsTau, b.history[i].epsTau) << "sweep " << i + 1;
    EXPECT_EQ(a.history[i].theta, b.history[i].theta) << "sweep " << i + 1;
    EXPECT_EQ(a.history[i].iterationError, b.history[i].iterationError) << "sweep " << i + 1;
    EXPECT_EQ(a.history[i].turned, b.history[i].turned) << "sweep " << i + 1;
  }
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.state.uDirichlet, b.state.uDirichlet);
  EXPECT_EQ(a.state.uNeumann, b.state.uNeumann);
  EXPECT_EQ(a.state.tractionDirichlet, b.state.tractionDirichlet);
  EXPECT_EQ(a.state.tractionNeumann, b.state.tractionNeumann);
  EXPECT_EQ(a.state.closed, b.state.closed);
}

} // namespace

TEST(SweepsKept, RelaxationsRememberAllThatTheyDependOn)
{
  constexpr int sweeps = 25;
  for (const char* type : {"Constant", "Aitken", "Automatic"}) {
    const auto whole = makeRelaxation(text("Type", type));
    whole->startWith({0.0, 8.0, false, false}); // far apart: Automatic mixes
    const auto all = tractions(*whole, atInterface(Vector(7, 0.0)), sweeps);
    for (const int done : {0, 1, 2, 9, 20}) {
      const auto before = makeRelaxation(text("Type", type)), after = makeRelaxation(text("Type", type));
      before->startWith({0.0, 8.0, false, false});
      const auto first = tractions(*before, atInterface(Vector(7, 0.0)), done);
      after->startWith({0.0, 8.0, false, false});
      ASSERT_TRUE(after->recall(before->memory()));
      const auto rest = tractions(*after, first.back(), sweeps - done);
      EXPECT_EQ(rest.back(), all.back()) << type << " after " << done;
    }
  }
}

TEST(SweepsKept, RelaxationsRefuseTheMemoryOfOthers)
{
  for (const char* type : {"Constant", "Aitken", "Automatic"}) {
    const auto controller = makeRelaxation(text("Type", type));
    controller->start();
    EXPECT_FALSE(controller->recall({{1.0}})) << type;
    EXPECT_FALSE(controller->recall({{1.0, 2.0}, {3.0}, {4.0}, {5.0}})) << type;
  }
}

TEST(SweepsKept, HaveTheBitsOfThoseThatWereNotEnded)
{
  std::size_t goneOn = 0;
  for (const std::string& how : waysToRelax())
    for (unsigned seed = 0; seed < 12; ++seed)
      for (const std::optional<double> goal : {std::optional<double>(), std::optional(1e-9)}) {
        SCOPED_TRACE(testing::Message() << how << ", seed " << seed);
        const auto system = randomSystem(seed, seed % 2 == 1);
        const auto coupling = neumannDirichlet(1e-12, how);
        const Kept whole = keepSweeps(*coupling, system, 4, std::nullopt, goal);
        for (const SweepsDone& done : whole.done) {
          const Kept rest = keepSweeps(*neumannDirichlet(1e-12, how), system, 4, done, goal);
          expectSameBits(rest.result, whole.result);
          EXPECT_EQ(rest.counts, whole.counts);
          ++goneOn;
        }
      }
  EXPECT_GT(goneOn, 200U);
}

TEST(SweepsKept, AreTheSameAsWithoutThem)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto system = randomSystem(seed, seed % 2 == 1);
    const auto coupling = neumannDirichlet(1e-10, waysToRelax().back());
    expectSameState(keepSweeps(*coupling, system, 3).result.state, run(*coupling, system).state, 1e-9);
  }
}

TEST(SweepsKept, AreRefusedOnAnotherInterface)
{
  const auto coupling = neumannDirichlet(1e-12);
  const Kept patch = keepSweeps(*coupling, patchSystem(), 4);
  ASSERT_FALSE(patch.done.empty());
  EXPECT_THROW(keepSweeps(*coupling, randomSystem(1, false), 4, patch.done.front()), InputError);
  const auto other = neumannDirichlet(1e-12, relaxation("Aitken", "Initial Theta", 0.5));
  EXPECT_THROW(keepSweeps(*other, patchSystem(), 4, patch.done.front()), InputError);
}
