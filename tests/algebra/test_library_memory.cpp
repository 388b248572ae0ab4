#include "ndframe/algebra/library_memory.hpp"

#include <atomic>
#include <cstdint>
#include <fstream>
#include <new>
#include <vector>

#include <cblas.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/test_main.hpp"
#include "ndframe/algebra/threads.hpp"

using namespace ndframe;

namespace
{

constexpr std::int64_t megabyte = 1 << 20;

/// Leaves this process so much more address space, and ends it when it hangs.
void leaveOnly(std::int64_t bytes)
{
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = rlim_t(pages * sysconf(_SC_PAGESIZE) + bytes);
  setrlimit(RLIMIT_AS, &limit);
  alarm(60);
}

/// True when a product of matrices of ones is right.
bool multiplies()
{
  constexpr int n = 200;
  const std::vector<double> A(std::size_t(n) * n, 1.0);
  std::vector<double> C(A.size());
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, A.data(), n, A.data(), n, 0.0, C.data(), n);
  return C.front() == n && C.back() == n;
}

/// Each test in a process of its own, for limits stay; not with the sanitizer, whose shadow memory fits under no limit.
class MemoryLimit : public testing::Test
{
protected:
  void SetUp() override
  {
    if (test::isSanitized())
      GTEST_SKIP();
    testing::FLAGS_gtest_death_test_style = "threadsafe";
  }
};

int claimed()
{
  try {
    claimLibraryMemory();
    return 0;
  } catch (const std::bad_alloc&) {
    return 2;
  }
}

} // namespace

TEST(LibraryMemory, WithoutALimitAllThreadsMayCallBlas)
{
  EXPECT_EQ(claimBlasBuffers(1), 1);
  EXPECT_EQ(claimBlasBuffers(1000), 1000);
}

TEST_F(MemoryLimit, TooLowIsRefusedAtOnce)
{
  EXPECT_EXIT(
      {
        leaveOnly(20 * megabyte);
        _exit(claimed());
      },
      testing::ExitedWithCode(2), "");
}

TEST_F(MemoryLimit, BlasWorksWithoutMoreMemoryOnceItIsClaimed)
{
  EXPECT_EXIT(
      {
        leaveOnly(8192 * megabyte);
        claimLibraryMemory();
        leaveOnly(2 * megabyte);
        _exit(multiplies() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST_F(MemoryLimit, OneThreadWhereMemoryIsScarceAndAllWhereItIsNot)
{
  for (const auto& [bytes, threads] : {std::pair(700 * megabyte, 1), std::pair(4096 * megabyte, 3)})
    EXPECT_EXIT(
        {
          leaveOnly(bytes);
          _exit(claimBlasBuffers(3));
        },
        testing::ExitedWithCode(threads), "")
        << bytes;
}

TEST_F(MemoryLimit, ConcurrentTasksFindTheirBuffers)
{
  for (const std::int64_t bytes : {700 * megabyte, 4096 * megabyte})
    EXPECT_EXIT(
        {
          leaveOnly(bytes);
          std::atomic<bool> right{true};
          runConcurrently(4, 4, [&](int) {
            for (int k = 0; k < 20; ++k)
              if (!multiplies())
                right = false;
          });
          _exit(right ? 0 : 1);
        },
        testing::ExitedWithCode(0), "")
        << bytes;
}
