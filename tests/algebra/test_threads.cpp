#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>

#include "ndframe/algebra/threads.hpp"
#include "serial_openmp.hpp"

/// libgomp's, or the one that stands before it.
extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned numThreads, unsigned flags);

using namespace ndframe;

namespace
{

/// The count of threads that OMP_NUM_THREADS asks for.
int threadsWith(const char* setting)
{
  setenv("OMP_NUM_THREADS", setting, 1);
  const int threads = numThreads(Comm::single());
  unsetenv("OMP_NUM_THREADS");
  return threads;
}

/// How many threads run a parallel region that is to have two.
int threadsOfARegion()
{
  std::atomic<int> threads{0};
  GOMP_parallel([](void* count) { ++*static_cast<std::atomic<int>*>(count); }, &threads, 2, 0);
  return threads;
}

} // namespace

TEST(Threads, RunEveryTaskOnce)
{
  for (const int threads : {1, 2, 3, 20}) {
    std::vector<std::atomic<int>> runs(7);
    runConcurrently(7, threads, [&](int i) { ++runs[std::size_t(i)]; });
    for (const auto& count : runs)
      EXPECT_EQ(count, 1) << threads << " threads";
  }
  runConcurrently(0, 4, [](int) { FAIL(); });
}

TEST(Threads, BeginWithTheLargestTask)
{
  std::vector<int> begun;
  runLargestFirst({2, 7, 1, 7}, 1, [&](int i) { begun.push_back(i); });
  EXPECT_THAT(begun, testing::ElementsAre(1, 3, 0, 2));
}

TEST(Threads, DoEveryNumberOfARangeOnce)
{
  for (const int threads : {1, 2, 5})
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<int> done(std::size_t(count), 0);
      runInRanges(count, threads, [&](int first, int last) {
        for (int i = first; i < last; ++i)
          ++done[std::size_t(i)];
      });
      EXPECT_EQ(done, std::vector<int>(std::size_t(count), 1)) << threads;
    }
}

TEST(Threads, ReportTheFirstFailedTaskByNumber)
{
  for (const int threads : {1, 2, 5}) {
    const auto fail = [&] {
      runConcurrently(5, threads, [](int i) {
        if (i >= 2)
          throw std::runtime_error("task " + std::to_string(i));
      });
    };
    EXPECT_THAT(fail, testing::ThrowsMessage<std::runtime_error>("task 2")) << threads << " threads";
  }
}

TEST(Threads, AreAsManyAsOpenMpIsAskedFor)
{
  EXPECT_EQ(threadsWith("3"), 3);
  EXPECT_EQ(threadsWith("2,1"), 2);
  EXPECT_GE(threadsWith("nonsense"), 1);
  EXPECT_GE(numThreads(Comm::single()), 1);
}

TEST(SerialOpenMp, HoldsForItsThreadWhileItLives)
{
  EXPECT_EQ(threadsOfARegion(), 2);
  {
    const SerialOpenMp outer;
    {
      const SerialOpenMp inner;
      EXPECT_EQ(threadsOfARegion(), 1);
    }
    EXPECT_EQ(threadsOfARegion(), 1);
    int elsewhere = 0;
    std::thread([&] { elsewhere = threadsOfARegion(); }).join();
    EXPECT_EQ(elsewhere, 2);
  }
  EXPECT_EQ(threadsOfARegion(), 2);
}
