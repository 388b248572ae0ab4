#include "ndframe/io/atomic_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gmock/gmock.h>

#include "io/temporary_folder.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;
using ndframe::test::FileSizeLimit;
using ndframe::test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace
{

std::string contentOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

TEST(AtomicFile, HoldsTheTextAndNothingElseIsLeft)
{
  const TemporaryFolder folder;
  const std::string text = "two\nlines\0and a zero";
  EXPECT_EQ(writeTextAtomically(folder.file("a.json"), text), std::int64_t(text.size()));
  EXPECT_EQ(contentOf(folder.file("a.json")), text);
  EXPECT_EQ(folder.numEntries(), 1);
}

TEST(AtomicFile, ReplacesAnOlderFile)
{
  const TemporaryFolder folder;
  writeTextAtomically(folder.file("a.json"), "a longer, older text");
  writeTextAtomically(folder.file("a.json"), "new");
  EXPECT_EQ(contentOf(folder.file("a.json")), "new");
}

TEST(AtomicFile, OldFileIsSeenUntilTheNewOneIsComplete)
{
  const TemporaryFolder folder;
  const auto path = folder.file("a.e");
  writeTextAtomically(path, "old");
  writeAtomically(path, [&](const std::string& temporary) {
    std::ofstream(temporary) << "new";
    EXPECT_NE(temporary, path);
    EXPECT_EQ(contentOf(path), "old");
  });
  EXPECT_EQ(contentOf(path), "new");
}

TEST(AtomicFile, FailedWriteKeepsTheOldFileAndLeavesNothing)
{
  const TemporaryFolder folder;
  const auto path = folder.file("a.e");
  writeTextAtomically(path, "old");
  const auto failing = [&] {
    writeAtomically(path, [](const std::string& temporary) {
      std::ofstream(temporary) << "half";
      throw std::runtime_error("the library gave up");
    });
  };
  EXPECT_THAT(failing, ThrowsMessage<InputError>(AllOf(HasSubstr(path), HasSubstr("the library gave up"))));
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.numEntries(), 1);
}

TEST(AtomicFile, ABugInTheWriterStaysABug)
{
  const TemporaryFolder folder;
  EXPECT_THROW(writeAtomically(folder.file("a.e"), [](const std::string&) { NDFRAME_ASSERT(false, "broken"); }),
               InternalError);
  EXPECT_EQ(folder.numEntries(), 0);
}

TEST(AtomicFile, FullDiskIsNamed)
{
  const TemporaryFolder folder;
  const auto write = [&] {
    const FileSizeLimit limit(1000);
    writeTextAtomically(folder.file("a.json"), std::string(100'000, 'x'));
  };
  EXPECT_THAT(write, ThrowsMessage<InputError>(AllOf(HasSubstr(folder.file("a.json")), HasSubstr("File too large"))));
  EXPECT_EQ(folder.numEntries(), 0);
}

TEST(AtomicFile, MissingFolderIsNamed)
{
  const TemporaryFolder folder;
  EXPECT_THAT([&] { writeTextAtomically(folder.file("missing/a.json"), ""); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("\"" + folder.file("missing") + "\" does not exist"),
                                              HasSubstr("create it or name another one"))));
}

TEST(AtomicFile, FileInPlaceOfTheFolderIsNamed)
{
  const TemporaryFolder folder;
  writeTextAtomically(folder.file("file"), "");
  EXPECT_THAT([&] { writeTextAtomically(folder.file("file/a.json"), ""); },
              ThrowsMessage<InputError>(HasSubstr("\"" + folder.file("file") + "\" is not a folder")));
}

TEST(AtomicFile, UnwritableFolderGivesTheSystemsReason)
{
  EXPECT_THAT([] { writeTextAtomically("/proc/a.json", ""); },
              ThrowsMessage<InputError>(HasSubstr("cannot write \"/proc/a.json\": No such file or directory")));
}

TEST(AtomicFile, FolderAsTargetIsRefused)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("results"));
  for (const auto* target : {"results", "results/"})
    EXPECT_THAT([&] { writeTextAtomically(folder.file(target), ""); },
                ThrowsMessage<InputError>(HasSubstr("it is a folder; name a file in it")));
}

TEST(AtomicFile, RemovesTheEarlierFileAndNoOther)
{
  const TemporaryFolder folder;
  removeEarlier(folder.file("a.e")); // there is none
  writeTextAtomically(folder.file("a.e"), "old");
  writeTextAtomically(folder.file("b.e"), "another");
  removeEarlier(folder.file("a.e"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.e")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("b.e")));
}

TEST(AtomicFile, DeviceIsNotReplaced)
{
  EXPECT_THAT([] { writeTextAtomically("/dev/null", ""); },
              ThrowsMessage<InputError>(HasSubstr("it is not a regular file")));
}
