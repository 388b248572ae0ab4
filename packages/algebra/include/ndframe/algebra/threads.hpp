#pragma once

#include <functional>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// The threads that a process may use: OMP_NUM_THREADS (its first number), without it all processors for a process that
/// runs alone, and one for each of several.
int numThreads(const Comm& comm);

/// Ends the threads that OpenBLAS starts before main; from now on BLAS computes on the calling thread alone. Leaves
/// them where a memory limit has no place for their buffers: claimLibraryMemory() refuses such a process.
void endBlasThreads();

/// BLAS computes on the calling thread alone, as long as the object lives: its own threads add in another order, so
/// that results would depend on their number, and they would compete with runConcurrently() and with other ranks.
class SerialBlas
{
public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;

private:
  int before_;
};

/// Runs task(0) ... task(count - 1) on up to `threads` threads, begun in this order, and waits for all of them. Under a
/// memory limit it takes no more threads than BLAS has memory for. With one thread they run one after the other, and
/// the first failure is the last task. Throws what the first task (by number) that failed threw.
void runConcurrently(int count, int threads, const std::function<void(int)>& task);

/// The same for tasks of these sizes: the longest begin first, so that short ones run beside them.
void runLargestFirst(const std::vector<int>& sizes, int threads, const std::function<void(int)>& task);

/// Cuts 0 ... count into ranges and runs task(first, last) for each on up to `threads` threads. What a task does for
/// one number must not depend on the range: so results have the same bits with any number of threads.
void runInRanges(int count, int threads, const std::function<void(int first, int last)>& task);

} // namespace ndframe
