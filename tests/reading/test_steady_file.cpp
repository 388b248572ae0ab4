#include "ndframe/reading/steady_file.hpp"

#include <chrono>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/reading/file_error.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace
{

TEST(SteadyFile, AnUntouchedFileIsUnchanged)
{
  const std::string path = scratchFile("steady", "abc");
  EXPECT_NO_THROW(SteadyFile(path).requireUnchanged());
}

TEST(SteadyFile, GrowthIsSeen)
{
  const std::string path = scratchFile("steady", "abc");
  const SteadyFile file(path);
  std::ofstream(path, std::ios::app) << "d";
  EXPECT_THAT([&] { file.requireUnchanged(); }, ThrowsMessage<FileError>(HasSubstr("changed while it was read")));
}

TEST(SteadyFile, OtherContentOfTheSameLengthIsSeen)
{
  const std::string path = scratchFile("steady", "abc");
  std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - std::chrono::seconds(1));
  const SteadyFile file(path);
  std::ofstream(path) << "abd";
  EXPECT_THROW(file.requireUnchanged(), FileError);
}

TEST(SteadyFile, AFileThatGoesAwayIsSeen)
{
  const std::string path = scratchFile("steady", "abc");
  const SteadyFile file(path);
  std::filesystem::remove(path);
  EXPECT_THROW(file.requireUnchanged(), FileError);
}

TEST(SteadyFile, PipesAreRefusedBeforeAnyoneWaits)
{
  const std::string path = scratchPath("pipe");
  std::filesystem::remove(path);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_THAT([&] { const SteadyFile file(path); }, ThrowsMessage<FileError>(HasSubstr("not a regular file")));
  std::filesystem::remove(path);
}

} // namespace
