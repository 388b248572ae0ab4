#include "ndframe/io/exodus_writer.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "io/sample_meshes.hpp"
#include "io/temporary_folder.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/atomic_file.hpp"

// What the file holds is read back with netCDF in read_back.py; here: what cannot be written.

using namespace ndframe;
using ndframe::test::FileSizeLimit;
using ndframe::test::sampleMesh;
using ndframe::test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace
{

/// One body with one nodal variable on one step.
struct Sample
{
  Mesh mesh = sampleMesh(2, 0.0);
  NodeMap nodes = makeNodeMap(mesh, 2);
  std::vector<ExodusBody> bodies{{"body", &mesh, &nodes}};
  std::vector<ExodusContactSide> contacts;
  std::vector<ExodusStep> steps{step(1.0)};

  ExodusStep step(double time) const
  {
    return {time, {{{"u", Vector(std::size_t(nodes.numNodes()), time)}}}, {{}}, {}, {}};
  }
  void write(const std::string& path) const { writeExodus(path, "title", bodies, contacts, steps, {}); }
};

/// The calls of write() and its kind that this process has made.
std::int64_t numWriteCalls()
{
  std::ifstream counters("/proc/self/io");
  std::string name;
  std::int64_t count = -1;
  while (counters >> name >> count)
    if (name == "syscw:")
      return count;
  throw std::runtime_error("/proc/self/io does not count");
}

} // namespace

TEST(ExodusWriter, WritesInLargePieces)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.steps.assign(5000, sample.step(1.0));
  const std::int64_t before = numWriteCalls();
  const auto bytes = writeAtomically(folder.file("a.e"), [&](const auto& path) { sample.write(path); });
  EXPECT_GT(bytes, 400'000);
  EXPECT_LT(numWriteCalls() - before, 20 + bytes / 100'000);
}

TEST(ExodusWriter, WritesAMeshWithoutSidesAndSteps)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.mesh.sides.clear();
  sample.steps.clear();
  EXPECT_GT(writeAtomically(folder.file("a.e"), [&](const auto& path) { sample.write(path); }), 0);
  EXPECT_EQ(folder.numEntries(), 1);
}

TEST(ExodusWriter, GrowsByTheSameAmountWithEveryStep)
{
  const TemporaryFolder folder;
  Sample sample;
  std::vector<std::int64_t> sizes;
  for (int steps = 1; steps <= 3; ++steps) {
    sample.steps.assign(std::size_t(steps), sample.step(steps));
    sizes.push_back(writeAtomically(folder.file("a.e"), [&](const auto& path) { sample.write(path); }));
  }
  EXPECT_EQ(sizes[2] - sizes[1], sizes[1] - sizes[0]);
  EXPECT_EQ(sizes[1] - sizes[0], std::int64_t(sizeof(double)) * (sample.nodes.numNodes() + 1));
}

TEST(ExodusWriter, FullDiskIsNamed)
{
  const TemporaryFolder folder;
  const auto bytes = writeAtomically(folder.file("a.e"), [](const auto& path) { Sample().write(path); });
  std::filesystem::remove(folder.file("a.e"));
  // Wherever the disk becomes full: in the header, in the arrays, or in the last buffered bytes.
  for (const auto limit : {std::int64_t(0), bytes / 4, bytes / 2, bytes - 1}) {
    const auto write = [&] {
      const FileSizeLimit full{rlim_t(limit)};
      writeAtomically(folder.file("a.e"), [](const auto& path) { Sample().write(path); });
    };
    EXPECT_THAT(write, ThrowsMessage<InputError>(HasSubstr("File too large"))) << limit << " of " << bytes;
    EXPECT_EQ(folder.numEntries(), 0);
  }
}

TEST(ExodusWriter, MissingFolderIsAnError)
{
  EXPECT_THAT([] { Sample().write("/no/such/folder/a.e"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("No such file or directory")));
}

TEST(ExodusWriter, RefusesNamesThatTheFormatCannotHold)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.bodies[0].name = std::string(300, 'b');
  EXPECT_THAT([&] { sample.write(folder.file("a.e")); },
              ThrowsMessage<std::runtime_error>(HasSubstr("names of that length")));
}

TEST(ExodusWriter, AssertsOneValuePerNode)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.steps[0].nodal[0][0].values.pop_back();
  EXPECT_THROW(sample.write(folder.file("a.e")), InternalError);
}

TEST(ExodusWriter, AssertsTheSameVariablesInEveryStep)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.steps.push_back(sample.step(2.0));
  sample.steps[1].nodal[0][0].name = "v";
  EXPECT_THROW(sample.write(folder.file("a.e")), InternalError);
}

TEST(ExodusWriter, AssertsFieldsForEveryContactSide)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.contacts = {{"contact", 0, sample.mesh.findSide("high")->facets}};
  EXPECT_THROW(sample.write(folder.file("a.e")), InternalError);
}
