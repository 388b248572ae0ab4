#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/mman.h>

#include <gtest/gtest.h>

#include "ndframe/base/ledger.hpp"

using ndframe::Ledger;

namespace
{

constexpr std::int64_t megabyte = std::int64_t(1) << 20;

/// Makes the process resident for that many megabytes, and gives them back to the system.
void touchMegabytes(std::int64_t count)
{
  const auto size = static_cast<std::size_t>(count * megabyte);
  void* block = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(block, MAP_FAILED);
  std::memset(block, 1, size);
  munmap(block, size);
}

bool marksCanBeReset()
{
  return bool(std::ofstream("/proc/self/clear_refs") << "5" << std::flush);
}

} // namespace

TEST(Ledger, CountsExactly)
{
  Ledger ledger;
  EXPECT_EQ(ledger.counted("factorisations"), 0);
  ledger.count("factorisations");
  ledger.count("factorisations");
  ledger.count("bytes", 1'000'000'000'000);
  EXPECT_EQ(ledger.counted("factorisations"), 2);
  EXPECT_EQ(ledger.counted("bytes"), 1'000'000'000'000);
  EXPECT_EQ(ledger.counts().size(), 2U);
}

TEST(Ledger, AddsStagesOfTheSameNameAndKeepsTheirOrder)
{
  Ledger ledger;
  for (const char* name : {"mesh", "factor", "mesh"})
    const auto timer = ledger.time(name);
  ASSERT_EQ(ledger.stages().size(), 2U);
  EXPECT_EQ(ledger.stages()[0].name, "mesh");
  EXPECT_EQ(ledger.stages()[1].name, "factor");
  EXPECT_GE(ledger.stages()[0].seconds, 0.0);
}

TEST(Ledger, LosesNothingThatThreadsCountAndTimeAtOnce)
{
  Ledger ledger;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&ledger, t] {
      for (int k = 0; k < 2000; ++k)
        ledger.count("sweeps");
      const auto timer = ledger.time("stage " + std::to_string(t));
    });
  for (auto& thread : threads)
    thread.join();
  EXPECT_EQ(ledger.counted("sweeps"), 8000);
  EXPECT_EQ(ledger.stages().size(), 4u);
}

TEST(Ledger, RestartsWithNothing)
{
  Ledger ledger;
  ledger.count("factorisations");
  {
    const auto timer = ledger.time("factor");
  }
  ledger.restart();
  EXPECT_TRUE(ledger.counts().empty());
  EXPECT_TRUE(ledger.stages().empty());
  ledger.count("factorisations");
  EXPECT_EQ(ledger.counted("factorisations"), 1);
}

TEST(Ledger, TimesFromConstructionToDestruction)
{
  Ledger ledger;
  const double before = ndframe::wallSeconds();
  double inside = 0.0;
  {
    const auto timer = ledger.time("busy");
    const double start = ndframe::wallSeconds();
    while (inside < 1e-3)
      inside = ndframe::wallSeconds() - start;
  }
  EXPECT_GE(ledger.stages()[0].seconds, inside);
  EXPECT_LE(ledger.stages()[0].seconds, ndframe::wallSeconds() - before);
}

TEST(Ledger, SeesTheMemoryOfAStageAndTheLargestOfTheRun)
{
  Ledger ledger;
  {
    const auto timer = ledger.time("large");
    touchMegabytes(64);
  }
  const auto large = ledger.stages()[0].peakBytes;
  {
    const auto timer = ledger.time("small");
    touchMegabytes(1);
  }
  const auto small = ledger.stages()[1].peakBytes;
  EXPECT_GE(large, 64 * megabyte);
  EXPECT_GE(small, megabyte);
  EXPECT_LE(small, marksCanBeReset() ? large - 32 * megabyte : large);
  EXPECT_GE(ndframe::peakMemory(), large); // although the mark was reset in between
}
