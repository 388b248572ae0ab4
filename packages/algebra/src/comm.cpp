#include "ndframe/algebra/comm.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

#include "exchange.hpp"
#include "ndframe/algebra/launcher.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

namespace
{

void initMpi(int* argc, char*** argv)
{
  if (mpiIsRunning())
    return;
  // Open MPI would spend 0.2 s looking for networks that nobody needs who is alone or on one machine, and 0.2 s on the
  // start of a helper that could start more processes; what the user has set goes first.
  const Launcher launcher = launcherOfThisProcess();
  if (!launcher.mayHaveStartedMore() || launcher.startedAllHere())
    setenv("OMPI_MCA_pml", "ob1", 0);
  if (!launcher.mayHaveStartedMore()) {
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  }
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
}

/// What needs MPI to be running when it ends.
std::vector<void (*)()>& endsBefore()
{
  static std::vector<void (*)()> ends;
  return ends;
}

/// What ranks got from each other since it was counted; MPI is called by one thread.
struct Reductions
{
  std::int64_t number = 0, bytes = 0, largest = 0;
};
Reductions uncounted;

template <class Values>
void broadcastTo(const Comm& comm, Values& values, MPI_Datatype type)
{
  if (comm.size() == 1)
    return;
  std::int64_t length = std::int64_t(values.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, 0, mpiComm(comm));
  values.resize(std::size_t(length));
  MPI_Bcast(values.data(), messageLength(values.size()), type, 0, mpiComm(comm));
}

} // namespace

void tellReduction(std::size_t bytes)
{
  ++uncounted.number;
  uncounted.bytes += std::int64_t(bytes);
  uncounted.largest = std::max(uncounted.largest, std::int64_t(bytes));
}

void countReductions(Ledger& ledger)
{
  const Reductions now = std::exchange(uncounted, {});
  if (now.number == 0)
    return;
  ledger.count("reductions", now.number);
  ledger.count("reduction bytes", now.bytes);
  ledger.count("largest reduction", std::max<std::int64_t>(0, now.largest - ledger.counted("largest reduction")));
}

Comm Comm::world(int& argc, char**& argv)
{
  const Launcher launcher = launcherOfThisProcess();
  if (!launcher.mayHaveStartedMore())
    return single();
  initMpi(&argc, &argv);
  const Comm comm = of(MPI_Comm_c2f(MPI_COMM_WORLD));
  if (comm.size() == 1 && launcher.size > 1)
    throw InputError(fmt::format("{} processes were started ({}), but this program's MPI joins only 1 of them: each "
                                 "would compute and write the same. Start them with the mpirun of the MPI that ndframe "
                                 "was built with, or with srun --mpi=pmix; for independent runs unset {}.",
                                 launcher.size, launcher.sizeVariable, launcher.sizeVariable));
  return comm;
}

Comm Comm::of(int communicator)
{
  const MPI_Comm handle = MPI_Comm_f2c(communicator);
  int rank = 0, size = 1;
  MPI_Comm_rank(handle, &rank);
  MPI_Comm_size(handle, &size);
  return Comm(rank, size, communicator);
}

Comm Comm::split(int colour) const
{
  if (size_ == 1)
    return *this;
  MPI_Comm part = MPI_COMM_NULL;
  MPI_Comm_split(mpiComm(*this), colour, rank_, &part);
  return of(MPI_Comm_c2f(part));
}

void Comm::sum(Vector& values) const
{
  reduceAll(values.data(), values.size(), MPI_SUM, *this);
}

std::int64_t Comm::sum(std::int64_t value) const
{
  reduceAll(&value, 1, MPI_SUM, *this);
  return value;
}

void Comm::broadcast(Vector& values) const
{
  broadcastTo(*this, values, MPI_DOUBLE);
}

void Comm::broadcast(std::string& text) const
{
  broadcastTo(*this, text, MPI_CHAR);
}

void Comm::abort(int exitCode) const
{
  if (size_ > 1)
    MPI_Abort(mpiComm(*this), exitCode);
}

void startMpi()
{
  initMpi(nullptr, nullptr);
}

bool mpiIsRunning()
{
  int started = 0, finished = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&finished);
  return started != 0 && finished == 0;
}

void beforeMpiEnds(void (*end)())
{
  endsBefore().push_back(end);
}

void finishMpi()
{
  for (; !endsBefore().empty(); endsBefore().pop_back())
    endsBefore().back()();
  if (mpiIsRunning())
    MPI_Finalize();
}

} // namespace ndframe
