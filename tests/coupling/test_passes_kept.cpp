// CouplingStart::sweeps of couplings without sweeps: status passes that go on from kept ones have the bits of those
// that were not ended.

#include <algorithm>

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

Kept keepPasses(const Coupling& coupling, const InterfaceSystem& system, std::optional<SweepsDone> after = std::nullopt)
{
  return keepSweeps(coupling, system, 1, std::move(after));
}

void expectSameBits(const CouplingResult& a, const CouplingResult& b)
{
  ASSERT_EQ(a.history.size(), 1U);
  ASSERT_EQ(b.history.size(), 1U);
  EXPECT_EQ(a.history[0].statusPasses, b.history[0].statusPasses);
  EXPECT_EQ(a.history[0].statusChanges, b.history[0].statusChanges);
  EXPECT_EQ(a.history[0].note, b.history[0].note);
  EXPECT_EQ(a.history[0].iterationError, b.history[0].iterationError);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.state.uDirichlet, b.state.uDirichlet);
  EXPECT_EQ(a.state.uNeumann, b.state.uNeumann);
  EXPECT_EQ(a.state.forceDirichlet, b.state.forceDirichlet);
  EXPECT_EQ(a.state.tractionDirichlet, b.state.tractionDirichlet);
  EXPECT_EQ(a.state.closed, b.state.closed);
}

std::unique_ptr<Coupling> coupling(const std::string& name)
{
  return makeCoupling("<Parameter name='Type' type='string' value='" + name + "'/>");
}

class KeptPasses : public testing::TestWithParam<const char*>
{};

} // namespace

TEST_P(KeptPasses, HaveTheBitsOfThoseThatWereNotEnded)
{
  std::size_t goneOn = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const InterfaceSystem& system : randomScenes(seed)) {
      const Kept whole = keepPasses(*coupling(GetParam()), system);
      EXPECT_EQ(int(whole.done.size()), whole.result.history[0].statusPasses - 1);
      for (const SweepsDone& done : whole.done) {
        const Kept rest = keepPasses(*coupling(GetParam()), system, done);
        expectSameBits(rest.result, whole.result);
        EXPECT_EQ(rest.counts, whole.counts);
        EXPECT_EQ(rest.done.size() + std::size_t(done.passes->passes), whole.done.size());
        ++goneOn;
      }
    }
  EXPECT_GT(goneOn, 100U);
}

TEST_P(KeptPasses, AreTheSameAsWithoutThem)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto system = randomSystem(seed, seed % 2 == 1);
    expectSameState(keepPasses(*coupling(GetParam()), system).result.state, run(*coupling(GetParam()), system).state,
                    1e-9);
  }
}

TEST_P(KeptPasses, AreRefusedOnAnotherInterface)
{
  Kept random;
  for (unsigned seed = 0; random.done.empty(); ++seed)
    random = keepPasses(*coupling(GetParam()), randomSystem(seed, true));
  EXPECT_THROW(keepPasses(*coupling(GetParam()), patchSystem(), random.done.front()), InputError);
}

TEST_P(KeptPasses, AreNoSweeps)
{
  const auto system = randomSystem(1, false);
  Kept passes;
  for (unsigned seed = 0; passes.done.empty(); ++seed)
    passes = keepPasses(*coupling(GetParam()), randomSystem(seed, true));
  EXPECT_THROW(keepPasses(*neumannDirichlet(1e-12), system, passes.done.front()), InputError);
  const Kept sweeps = keepPasses(*neumannDirichlet(1e-12), system);
  ASSERT_FALSE(sweeps.done.empty());
  EXPECT_THROW(keepPasses(*coupling(GetParam()), system, sweeps.done.front()), InputError);
}

INSTANTIATE_TEST_SUITE_P(Couplings, KeptPasses, testing::Values("Monolithic", "FETI", "Neumann-Neumann"),
                         [](const auto& which) {
                           std::string name = which.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST(PassesOfForces, AreRefusedByThoseThatHaveNone)
{
  std::optional<SweepsDone> ofForces;
  for (unsigned seed = 0; !ofForces; ++seed)
    for (const SweepsDone& done : keepPasses(*coupling("FETI"), randomSystem(seed, true)).done)
      ofForces = done;
  EXPECT_THROW(keepPasses(*coupling("Monolithic"), randomSystem(0, true), ofForces), InputError);
}
