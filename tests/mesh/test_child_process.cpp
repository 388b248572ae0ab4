#include "child_process.hpp"

#include <csignal>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "file_error.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

using namespace ndframe;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace
{

TEST(ChildProcess, GivesBackItsResult)
{
  const std::string large(300'000, 'x'); // more than a pipe holds
  EXPECT_EQ(runInChild([&] { return large; }, "it"), large);
}

TEST(ChildProcess, CrashIsAMessageHere)
{
  EXPECT_THAT(
      [] {
        runInChild(
            []() -> std::string {
              std::raise(SIGKILL);
              return {};
            },
            "the library");
      },
      ThrowsMessage<FileError>(HasSubstr("the library crashed on this file (signal 9)")));
}

TEST(ChildProcess, FileErrorAndBugsPassThrough)
{
  EXPECT_THAT([] { runInChild([]() -> std::string { throw FileError("bad"); }, "it"); },
              ThrowsMessage<FileError>(HasSubstr("bad")));
  EXPECT_THROW(runInChild([]() -> std::string { throw std::logic_error("bug"); }, "it"), InternalError);
}

TEST(ChildProcess, EndlessWorkIsEnded)
{
  const auto forever = []() -> std::string {
    for (volatile int i = 0;; i = i + 1)
      ;
  };
  EXPECT_THAT(
      [&] {
        runInChild(forever, "it", {0, 1});
      },
      ThrowsMessage<FileError>(HasSubstr("did not come to an end")));
}

TEST(MeshBytes, ReadBackToTheSameMesh)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, 1, 0, 0, 1};
  mesh.cells = {0, 1, 2};
  mesh.sides = {{"bottom", {{0, 2}}}, {"", {}}};
  mesh.notes = {"a note"};
  const std::string bytes = toBytes(mesh);
  const Mesh back = meshFromBytes(bytes);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.cells, mesh.cells);
  EXPECT_EQ(back.sides.size(), 2U);
  EXPECT_EQ(toBytes(back), bytes);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(meshFromBytes(std::string_view(bytes).substr(0, length)), InternalError);
}

} // namespace
