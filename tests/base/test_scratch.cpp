#include "ndframe/base/scratch.hpp"

#include <fstream>

#include <gtest/gtest.h>
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

TEST_F(ScratchTest, RemoveScratchTakesUnfinishedFilesAndFolders)
{
  const Scratch folder(file("folder")), unfinished(makeFile(file("a")));
  fs::create_directory(file("folder"));
  makeFile(file("folder") / "inside");
  const fs::path kept = makeFile(file("kept"));
  {
    const Scratch finished(kept);
    fs::rename(kept, file("finished"));
  }
  makeFile(kept); // no object stands for it any more
  removeScratch();
  EXPECT_FALSE(fs::exists(file("folder")));
  EXPECT_FALSE(fs::exists(file("a")));
  EXPECT_TRUE(fs::exists(kept));
  EXPECT_TRUE(fs::exists(file("finished")));
}

} // namespace
