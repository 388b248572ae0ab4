#include "ndframe/reading/child_process.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "common/test_main.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/reading/file_error.hpp"

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

TEST(ChildProcess, StartsThreadsButNoProgramWhereItMayNot)
{
  ChildLimits limits;
  limits.mayStartPrograms = false;
  const auto withThread = [] {
    std::string text;
    std::thread([&] { text = "done"; }).join();
    return text;
  };
  EXPECT_EQ(runInChild(withThread, "it", limits), "done");
  const std::vector<std::function<void()>> ways{[] { fork(); }, [] { std::fclose(popen("true", "r")); },
                                                [] { execl("/bin/true", "true", static_cast<char*>(nullptr)); },
                                                [] { std::thread([] { fork(); }).join(); }};
  for (const auto& way : ways)
    try {
      runInChild([&] { return way(), std::string(); }, "it", limits);
      ADD_FAILURE();
    } catch (const ChildFailure& failure) {
      EXPECT_EQ(failure.kind(), ChildFailure::Kind::StartsProgram);
    }
}

TEST(ChildProcess, ExitIsNoCrashAndRunsNoHandlerOfTheParent)
{
  const std::string parents = testing::TempDir() + "/ndframe-child-exit";
  std::remove(parents.c_str());
  static std::string left; // the handler runs again at the end of this process
  left = parents;
  std::atexit([] { std::ofstream file(left); });
  try {
    runInChild([]() -> std::string { std::exit(0); }, "it");
    ADD_FAILURE();
  } catch (const ChildFailure& failure) {
    EXPECT_EQ(failure.kind(), ChildFailure::Kind::Exited);
  }
  EXPECT_FALSE(std::ifstream(parents).is_open());
  left.clear();
}

TEST(ChildProcess, AChildThatWaitsIsEnded)
{
  const ChildLimits limits{0, 0, 1};
  try {
    runInChild(
        []() -> std::string {
          pause();
          return {};
        },
        "it", limits);
    ADD_FAILURE();
  } catch (const ChildFailure& failure) {
    EXPECT_EQ(failure.kind(), ChildFailure::Kind::Waits);
    EXPECT_THAT(failure.what(), HasSubstr("it waits for something and has no result after 1 s"));
  }
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
  EXPECT_THAT([&] { runInChild(forever, "it", {0, 1}); }, ThrowsMessage<FileError>(HasSubstr("did not finish")));
}

TEST(ChildProcess, WorkThatTakesTooMuchMemoryIsRefused)
{
  if (test::isSanitized())
    GTEST_SKIP() << "its shadow memory does not fit under a limit";
  const std::int64_t limit = 64 << 20;
  const auto taking = [](std::size_t bytes) {
    return [bytes] { return std::to_string(std::string(bytes, 'x').size()); };
  };
  EXPECT_EQ(runInChild(taking(std::size_t(1) << 20), "it", {limit, 0}), "1048576");
  EXPECT_THAT(
      [&] {
        runInChild(taking(std::size_t(256) << 20), "it", {limit, 0});
      },
      ThrowsMessage<FileError>(HasSubstr("it asks for more memory than the process may use")));
}

TEST(ChildProcess, ThreadThatTakesTooMuchMemoryIsNoCrash)
{
  if (test::isSanitized())
    GTEST_SKIP() << "its shadow memory does not fit under a limit";
  const auto work = [] {
    std::thread([] { std::string(std::size_t(256) << 20, 'x'); }).join();
    return std::string();
  };
  EXPECT_THAT(
      [&] {
        runInChild(work, "it", {64 << 20, 0});
      },
      ThrowsMessage<FileError>(HasSubstr("it asks for more memory than the process may use")));
}

} // namespace
