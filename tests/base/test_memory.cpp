// What a process may still take, on machines made of files.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/test_main.hpp"
#include "ndframe/base/memory.hpp"

using namespace ndframe;

namespace
{

constexpr std::int64_t MB = 1 << 20;

/// A folder with the files of a machine that has 8 GB left.
class Machine : public testing::Test
{
protected:
  Machine() : root_(testing::TempDir() + "/ndframe-machine-" + std::to_string(getpid()))
  {
    std::filesystem::remove_all(root_);
    write("/proc/meminfo", "MemTotal: 16777216 kB\nMemFree: 100 kB\nMemAvailable: 8388608 kB\n");
  }
  ~Machine() override { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const
  {
    std::filesystem::create_directories(std::filesystem::path(root_ + path).parent_path());
    std::ofstream(root_ + path) << text;
  }
  /// A group with these megabytes as limit, in use, and in files that can be dropped.
  void group(const std::string& path, int limit, int used, int files) const
  {
    write("/sys/fs/cgroup" + path + "/memory.max", std::to_string(limit * MB) + "\n");
    write("/sys/fs/cgroup" + path + "/memory.current", std::to_string(used * MB) + "\n");
    write("/sys/fs/cgroup" + path + "/memory.stat",
          "anon 1\ninactive_file " + std::to_string(files * MB) + "\nactive_file 5\n");
  }
  MemoryLeft left() const { return memoryLeft(root_); }

private:
  std::string root_;
};

TEST_F(Machine, HasWhatItSaysIsAvailable)
{
  EXPECT_EQ(left().bytes, 8192 * MB);
  EXPECT_EQ(left().text(), "8.59 GB (the machine)");
}

TEST_F(Machine, AContainerLeavesItsLimitWithoutWhatIsInUseButForFiles)
{
  write("/proc/self/cgroup", "0::/\n");
  group("", 1024, 600, 200);
  EXPECT_EQ(left().bytes, 624 * MB);
  EXPECT_EQ(left().limit, "the container (cgroup)");
  group("", 1024, 2000, 0);
  EXPECT_EQ(left().bytes, 0);
}

TEST_F(Machine, EveryGroupAboveCounts)
{
  write("/proc/self/cgroup", "0::/user/job\n");
  group("/user", 500, 100, 0);
  group("/user/job", 2000, 0, 0);
  EXPECT_EQ(left().bytes, 400 * MB);
  write("/sys/fs/cgroup/user/memory.max", "max\n");
  EXPECT_EQ(left().bytes, 2000 * MB);
}

TEST_F(Machine, GroupsOfTheFirstVersionCount)
{
  write("/proc/self/cgroup", "7:cpu,memory:/job\n0::/\n");
  write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", std::to_string(300 * MB));
  write("/sys/fs/cgroup/memory/job/memory.usage_in_bytes", std::to_string(100 * MB));
  write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712");
  write("/sys/fs/cgroup/memory/memory.usage_in_bytes", "1000");
  EXPECT_EQ(left().bytes, 200 * MB);
}

TEST_F(Machine, WithoutFilesNobodyTells)
{
  EXPECT_EQ(memoryLeft("/nowhere").text(), "an unknown amount");
}

TEST(MemoryLeft, IsLessUnderALimitOfTheProcess)
{
  if (test::isSanitized())
    GTEST_SKIP() << "its shadow memory does not fit under a limit";
  rlimit before{};
  getrlimit(RLIMIT_DATA, &before);
  rlimit limit = before;
  limit.rlim_cur = 256 * MB;
  setrlimit(RLIMIT_DATA, &limit);
  const MemoryLeft left = memoryLeft();
  setrlimit(RLIMIT_DATA, &before);
  EXPECT_EQ(left.limit, "ulimit -d");
  EXPECT_LT(left.bytes, 256 * MB);
  EXPECT_GT(memoryLeft().bytes, MB);
}

} // namespace
