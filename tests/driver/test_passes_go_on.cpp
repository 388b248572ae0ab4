// Output/Checkpoint of couplings without sweeps: runs that go on from the file of any status pass have the bits of one
// that was not ended.

#include <gtest/gtest.h>

#include "driver/scene.hpp"
#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/report/checkpoint_bytes.hpp"
#include "ndframe/run/summarize.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

struct Kept
{
  Run run;
  std::vector<std::string> files;
  std::map<std::string, std::int64_t> counts;
};

Kept keepPasses(const Scene& scene, const std::string& from = {})
{
  Kept kept;
  Restart restart;
  restart.sweeps = 1;
  restart.write = [&](const Checkpoint& checkpoint) { kept.files.push_back(toBytes(checkpoint)); };
  if (!from.empty())
    restart.from = checkpointFromBytes(from, "", versionText());
  Ledger ledger;
  kept.run = runDeck(readSettings(scene.params()), components(), Comm::single(), ledger, silentLog(), {}, {}, restart);
  kept.counts = ledger.counts();
  return kept;
}

void expectSameBits(const Run& a, const Run& b)
{
  ASSERT_EQ(a.solved.fields.size(), b.solved.fields.size());
  for (std::size_t body = 0; body < a.solved.fields.size(); ++body)
    EXPECT_EQ(displacement(a, int(body)), displacement(b, int(body))) << body;
  EXPECT_EQ(traction(a), traction(b));
  EXPECT_EQ(statuses(a), statuses(b));
  EXPECT_EQ(a.summary.energy, b.summary.energy);
  ASSERT_EQ(a.certificate.has_value(), b.certificate.has_value());
  EXPECT_EQ(a.summary.coupling->reason, b.summary.coupling->reason);
}

bool hasPasses(const std::string& file)
{
  const Checkpoint checkpoint = checkpointFromBytes(file, "", versionText());
  return checkpoint.sweeps && checkpoint.sweeps->done.passes;
}

/// From every `stride`-th file.
void expectGoesOn(const Scene& scene, std::size_t leastFiles, std::size_t stride = 1)
{
  const Kept whole = keepPasses(scene);
  std::size_t ofPasses = 0;
  for (const std::string& file : whole.files)
    ofPasses += hasPasses(file) ? 1 : 0;
  EXPECT_GE(ofPasses, leastFiles);
  for (std::size_t i = 0; i < whole.files.size(); i += stride) {
    SCOPED_TRACE(testing::Message() << "file " << i + 1 << " of " << whole.files.size());
    const Kept rest = keepPasses(scene, whole.files[i]);
    expectSameBits(rest.run, whole.run);
    EXPECT_EQ(rest.counts, whole.counts);
    ASSERT_EQ(rest.files.size(), whole.files.size() - i - 1);
  }
}

Scene contactLoss()
{
  Scene scene("contact-loss");
  scene.set("Bodies/upper/Mesh/Cells={20, 4}").set("Bodies/lower/Mesh/Cells={40, 4}");
  return scene;
}

/// Few cells, solved whole.
Scene wholeSphere()
{
  Scene scene("hertz-3d");
  for (const char* body : {"sphere", "block"})
    scene.set(std::string("Bodies/") + body + "/Mesh/Cells={6, 6, 4}");
  scene.set("Linear Solver/Type=Multigrid");
  return scene;
}

/// Pressed on a part of its top: contact opens, and bricks are loose on the way.
Scene pressedWall(const char* coupling)
{
  Scene scene("wall");
  scene.changeAll("Cells", [](const std::string&) { return "{4, 2}"; });
  scene.changeAll("Value", [](const std::string&) { return "(x<2)+0.01"; });
  return scene.set(std::string("Coupling/Type=") + coupling);
}

} // namespace

TEST(PassesGoOn, OfTwoCondensedBodies)
{
  expectGoesOn(contactLoss().set("Coupling/Type=Monolithic"), 2);
}

TEST(PassesGoOn, OfOperatorsThatAreApplied)
{
  expectGoesOn(contactLoss().set("Coupling/Type=Monolithic").set("Interface Operator/Type=Matrix Free"), 2);
}

TEST(PassesGoOn, OfANetwork)
{
  for (const char* coupling : {"Monolithic", "FETI", "Neumann-Neumann"}) {
    SCOPED_TRACE(coupling);
    expectGoesOn(pressedWall(coupling), 2);
  }
}

TEST(PassesGoOn, OfContactInMeans)
{
  expectGoesOn(Scene::fromFile(NDFRAME_MORTAR).set("Coupling/Type=Monolithic"), 1);
}

TEST(PassesGoOn, OfWholeSolids)
{
  expectGoesOn(wholeSphere(), 2);
}

TEST(PassesGoOn, OfWholeSolidsOnTheWayToATarget)
{
  Scene scene("contact-loss-3d");
  scene.set("Linear Solver/Type=Multigrid").set("Accuracy/Target=0.1");
  expectGoesOn(scene, 3);
}

TEST(PassesGoOn, OfANetworkOnTheWayToATarget)
{
  expectGoesOn(pressedWall("FETI").set("Error Estimation/Estimators={Global}").set("Accuracy/Target=0.3"), 2, 3);
}

TEST(PassesGoOn, FilesChangeNoBitsOfWholeSolids)
{
  const Kept kept = keepPasses(wholeSphere());
  const Outcome alone = wholeSphere().run();
  expectSameBits(kept.run, alone.run);
  EXPECT_EQ(kept.counts, alone.ledger->counts());
}
