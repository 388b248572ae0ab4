#include <chrono>
#include <ctime>

#include <mpi.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "ndframe/algebra/launcher.hpp"

/// Where several processes share a processor, who waits sleeps. MPI offers its processor to the others instead, over
/// and over: on four processes with two processors that took a third of all processor time, and a tenth where
/// collective functions did so beside sleeping ones. The functions that wait are those of MPI's profiling interface;
/// the libraries call them, too. Elsewhere they are MPI's own.
namespace
{

bool sharesProcessors()
{
  static const bool shares = ndframe::launcherOfThisProcess().sharesProcessors();
  return shares;
}

constexpr timespec nap{0, 20'000};

/// test(&isDone) until it is. A nap is longer than most messages of a small scene take: before it the processor is
/// offered to the others some times (a scene of 864 cells on three processes: 16 -> 2.8 s).
template <class Test>
int waitAsleep(const Test& test)
{
  constexpr int atOnce = 4, soon = 40; // tests of what is about to arrive, and of what others may be about to send
  for (int tried = 0;; ++tried) {
    int isDone = 0;
    if (const int error = test(&isDone); isDone != 0 || error != MPI_SUCCESS)
      return error;
    if (tried >= soon)
      nanosleep(&nap, nullptr);
    else if (tried >= atOnce)
      sched_yield();
  }
}

} // namespace

extern "C" {

/// Offers the processor to others; MPI does so after every test that finds nothing. Beside another program that always
/// computes, an offer takes a slice of that one's time, 3 ms and more (Linux 6.18), where a message takes microseconds:
/// after such an offer naps stand for the next ones. A scene of 864 cells beside two such programs on two processors:
/// 15 -> 3 s on three processes, 20 -> 5 s on four.
int sched_yield() noexcept
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds dear(1);
  constexpr int napsInstead = 30; // a hundred cost small scenes, alone on the machine, a sixth of their time
  static thread_local int naps = 0;
  if (naps > 0) {
    --naps;
    nanosleep(&nap, nullptr);
    return 0;
  }
  const Clock::time_point before = Clock::now();
  const auto error = int(syscall(SYS_sched_yield));
  if (Clock::now() - before > dear)
    naps = napsInstead;
  return error;
}

int MPI_Wait(MPI_Request* request, MPI_Status* status)
{
  if (!sharesProcessors())
    return PMPI_Wait(request, status);
  return waitAsleep([&](int* isDone) { return PMPI_Test(request, isDone, status); });
}

int MPI_Waitall(int count, MPI_Request requests[], MPI_Status statuses[])
{
  if (!sharesProcessors())
    return PMPI_Waitall(count, requests, statuses);
  return waitAsleep([&](int* isDone) { return PMPI_Testall(count, requests, isDone, statuses); });
}

int MPI_Recv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Status* status)
{
  if (!sharesProcessors())
    return PMPI_Recv(data, count, type, from, tag, comm, status);
  MPI_Request request = MPI_REQUEST_NULL;
  if (const int error = PMPI_Irecv(data, count, type, from, tag, comm, &request); error != MPI_SUCCESS)
    return error;
  return MPI_Wait(&request, status);
}

// A function that blocks: where who waits sleeps, its non-blocking form until it ends.
#define NDFRAME_BLOCKING(name, begin, parameters, ...)                                                                 \
  int name parameters                                                                                                  \
  {                                                                                                                    \
    if (!sharesProcessors())                                                                                           \
      return P##name(__VA_ARGS__);                                                                                     \
    MPI_Request request = MPI_REQUEST_NULL;                                                                            \
    if (const int error = begin(__VA_ARGS__, &request); error != MPI_SUCCESS)                                          \
      return error;                                                                                                    \
    return MPI_Wait(&request, MPI_STATUS_IGNORE);                                                                      \
  }

NDFRAME_BLOCKING(MPI_Send, PMPI_Isend, (const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm),
                 data, count, type, to, tag, comm)

NDFRAME_BLOCKING(MPI_Barrier, PMPI_Ibarrier, (MPI_Comm comm), comm)

NDFRAME_BLOCKING(MPI_Bcast, PMPI_Ibcast, (void* data, int count, MPI_Datatype type, int root, MPI_Comm comm), data,
                 count, type, root, comm)

NDFRAME_BLOCKING(MPI_Allreduce, PMPI_Iallreduce,
                 (const void* own, void* all, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm comm), own, all,
                 count, type, operation, comm)

NDFRAME_BLOCKING(MPI_Reduce, PMPI_Ireduce,
                 (const void* own, void* all, int count, MPI_Datatype type, MPI_Op operation, int root, MPI_Comm comm),
                 own, all, count, type, operation, root, comm)

NDFRAME_BLOCKING(MPI_Scan, PMPI_Iscan,
                 (const void* own, void* all, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm comm), own, all,
                 count, type, operation, comm)

NDFRAME_BLOCKING(MPI_Gather, PMPI_Igather,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, int numIn, MPI_Datatype typeIn, int root,
                  MPI_Comm comm),
                 out, numOut, typeOut, in, numIn, typeIn, root, comm)

NDFRAME_BLOCKING(MPI_Gatherv, PMPI_Igatherv,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, const int numsIn[], const int firstIn[],
                  MPI_Datatype typeIn, int root, MPI_Comm comm),
                 out, numOut, typeOut, in, numsIn, firstIn, typeIn, root, comm)

NDFRAME_BLOCKING(MPI_Scatter, PMPI_Iscatter,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, int numIn, MPI_Datatype typeIn, int root,
                  MPI_Comm comm),
                 out, numOut, typeOut, in, numIn, typeIn, root, comm)

NDFRAME_BLOCKING(MPI_Allgather, PMPI_Iallgather,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, int numIn, MPI_Datatype typeIn,
                  MPI_Comm comm),
                 out, numOut, typeOut, in, numIn, typeIn, comm)

NDFRAME_BLOCKING(MPI_Allgatherv, PMPI_Iallgatherv,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, const int numsIn[], const int firstIn[],
                  MPI_Datatype typeIn, MPI_Comm comm),
                 out, numOut, typeOut, in, numsIn, firstIn, typeIn, comm)

NDFRAME_BLOCKING(MPI_Alltoall, PMPI_Ialltoall,
                 (const void* out, int numOut, MPI_Datatype typeOut, void* in, int numIn, MPI_Datatype typeIn,
                  MPI_Comm comm),
                 out, numOut, typeOut, in, numIn, typeIn, comm)

NDFRAME_BLOCKING(MPI_Alltoallv, PMPI_Ialltoallv,
                 (const void* out, const int numsOut[], const int firstOut[], MPI_Datatype typeOut, void* in,
                  const int numsIn[], const int firstIn[], MPI_Datatype typeIn, MPI_Comm comm),
                 out, numsOut, firstOut, typeOut, in, numsIn, firstIn, typeIn, comm)

} // extern "C"
