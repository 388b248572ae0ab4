#include "ndframe/algebra/threads.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <thread>

#include <cblas.h>

#include "ndframe/algebra/library_memory.hpp"

/// Of OpenBLAS, not in its header.
extern "C" int blas_thread_shutdown_();

namespace ndframe
{

SerialBlas::SerialBlas() : before_(openblas_get_num_threads())
{
  if (before_ != 1) // even this call would start threads that were ended
    openblas_set_num_threads(1);
}

SerialBlas::~SerialBlas()
{
  if (before_ != 1)
    openblas_set_num_threads(before_);
}

int numThreads(const Comm& comm)
{
  const char* wanted = std::getenv("OMP_NUM_THREADS");
  const int number = wanted ? std::atoi(wanted) : 0;
  if (number > 0)
    return number;
  return comm.size() > 1 ? 1 : std::max(1, int(std::thread::hardware_concurrency()));
}

void endBlasThreads()
{
  // Else they may be asking for memory for ever and cannot be joined, or they take what is kept for others as soon as
  // they run: claimLibraryMemory() finds them and refuses.
  if (!blasBuffersFit())
    return;
  openblas_set_num_threads(1);
  blas_thread_shutdown_();
}

void runLargestFirst(const std::vector<int>& sizes, int threads, const std::function<void(int)>& task)
{
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return sizes[std::size_t(a)] > sizes[std::size_t(b)]; });
  runConcurrently(int(order.size()), threads, [&](int i) { task(order[std::size_t(i)]); });
}

void runInRanges(int count, int threads, const std::function<void(int, int)>& task)
{
  constexpr int perThread = 4; // where one is held up, others take what is left
  const int ranges = threads == 1 ? 1 : std::max(1, std::min(count, perThread * threads));
  const auto begin = [&](int range) { return int(std::int64_t(count) * range / ranges); };
  runConcurrently(ranges, threads, [&](int range) { task(begin(range), begin(range + 1)); });
}

void runConcurrently(int count, int threads, const std::function<void(int)>& task)
{
  const int workers = std::min(count, threads) <= 1 ? 1 : claimBlasBuffers(std::min(count, threads));
  if (workers == 1) {
    for (int i = 0; i < count; ++i)
      task(i);
    return;
  }
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < count; i = next++)
      try {
        task(i);
      } catch (...) {
        failures[std::size_t(i)] = std::current_exception();
      }
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < workers; ++t)
    helpers.emplace_back(work);
  work();
  for (auto& helper : helpers)
    helper.join();
  for (const auto& failure : failures)
    if (failure)
      std::rethrow_exception(failure);
}

} // namespace ndframe
