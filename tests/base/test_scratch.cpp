#include "ndframe/base/scratch.hpp"

#include <deque>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace ndframe;
namespace fs = std::filesystem;

namespace
{

fs::path makeFile(const fs::path& path)
{
  std::ofstream(path) << "unfinished";
  return path;
}

class ScratchTest : public testing::Test
{
protected:
  ScratchTest()
  {
    std::string name = testing::TempDir() + "ndframe-scratch-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~ScratchTest() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const { return folder_ / name; }

private:
  fs::path folder_;
};

TEST_F(ScratchTest, FileGoesWithItsObject)
{
  {
    const Scratch scratch(file("a"));
    EXPECT_FALSE(fs::exists(file("a"))) << "the object makes nothing";
    makeFile(scratch.path());
  }
  EXPECT_FALSE(fs::exists(file("a")));
}

TEST_F(ScratchTest, FolderGoesWithAllThatIsInIt)
{
  {
    const Scratch scratch(file("folder"));
    fs::create_directory(file("folder"));
    makeFile(file("folder") / "a");
  }
  EXPECT_FALSE(fs::exists(file("folder")));
}

TEST_F(ScratchTest, RenamedFileStays)
{
  {
    const Scratch scratch(makeFile(file("a")));
    fs::rename(file("a"), file("b"));
  }
  EXPECT_TRUE(fs::exists(file("b")));
}

TEST_F(ScratchTest, RemoveScratchTakesUnfinishedFilesAndTheirFolder)
{
  const Scratch folder(file("folder"));
  fs::create_directory(file("folder"));
  const Scratch inside(makeFile(file("folder") / "a"));
  const fs::path kept = makeFile(file("kept"));
  {
    const Scratch finished(kept);
    fs::rename(kept, file("finished"));
  }
  makeFile(kept); // no object stands for it any more
  removeScratch();
  EXPECT_FALSE(fs::exists(file("folder")));
  EXPECT_TRUE(fs::exists(kept));
  EXPECT_TRUE(fs::exists(file("finished")));
}

TEST_F(ScratchTest, MoreObjectsThanTheHandlerKnowsStillCleanUp)
{
  {
    std::deque<Scratch> many;
    for (int i = 0; i < 20; ++i)
      makeFile(many.emplace_back(file(std::to_string(i))).path());
  }
  for (int i = 0; i < 20; ++i)
    EXPECT_FALSE(fs::exists(file(std::to_string(i)))) << i;
  const Scratch next(makeFile(file("next"))); // the places are free again
  removeScratch();
  EXPECT_FALSE(fs::exists(file("next")));
}

} // namespace
