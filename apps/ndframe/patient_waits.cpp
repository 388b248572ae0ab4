#include <cstdlib>
#include <ctime>
#include <initializer_list>

#include <mpi.h>
#include <unistd.h>

/// Where several processes share a processor, who waits sleeps. MPI offers its processor to the others instead, over
/// and over: on four processes with two processors that took a third of all processor time. The functions that wait are
/// those of MPI's profiling interface; the libraries call them, too. Elsewhere they are MPI's own.
namespace
{

bool sharesProcessors()
{
  static const bool shares = [] {
    for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE"})
      if (const char* const count = std::getenv(name))
        return std::atol(count) > sysconf(_SC_NPROCESSORS_ONLN);
    return false;
  }();
  return shares;
}

/// test(&isDone) until it is.
template <class Test>
int waitAsleep(const Test& test)
{
  constexpr int atOnce = 20; // what is about to arrive
  constexpr timespec nap{0, 20'000};
  for (int tried = 0;; ++tried) {
    int isDone = 0;
    if (const int error = test(&isDone); isDone != 0 || error != MPI_SUCCESS)
      return error;
    if (tried >= atOnce)
      nanosleep(&nap, nullptr);
  }
}

int waitForAll(MPI_Comm comm)
{
  if (!sharesProcessors())
    return MPI_SUCCESS;
  MPI_Request all = MPI_REQUEST_NULL;
  if (const int error = PMPI_Ibarrier(comm, &all); error != MPI_SUCCESS)
    return error;
  return waitAsleep([&](int* isDone) { return PMPI_Test(&all, isDone, MPI_STATUS_IGNORE); });
}

} // namespace

extern "C" {

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

int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  if (!sharesProcessors())
    return PMPI_Send(data, count, type, to, tag, comm);
  MPI_Request request = MPI_REQUEST_NULL;
  if (const int error = PMPI_Isend(data, count, type, to, tag, comm, &request); error != MPI_SUCCESS)
    return error;
  return MPI_Wait(&request, MPI_STATUS_IGNORE);
}

int MPI_Allreduce(const void* own, void* all, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
{
  const int error = waitForAll(comm);
  return error == MPI_SUCCESS ? PMPI_Allreduce(own, all, count, type, operation, comm) : error;
}

int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm)
{
  const int error = waitForAll(comm);
  return error == MPI_SUCCESS ? PMPI_Bcast(data, count, type, root, comm) : error;
}

int MPI_Barrier(MPI_Comm comm)
{
  const int error = waitForAll(comm);
  return error == MPI_SUCCESS ? PMPI_Barrier(comm) : error;
}

} // extern "C"
