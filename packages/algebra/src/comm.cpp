#include "ndframe/algebra/comm.hpp"

#include <array>
#include <cstdlib>
#include <limits>

#include <mpi.h>

#include "krylov_module.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

/// How many processes the launcher started; 1 without a launcher.
int launchedProcesses()
{
  constexpr std::array<const char*, 2> variables = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  for (const char* variable : variables)
    if (const char* value = std::getenv(variable))
      return std::atoi(value);
  return 1;
}

void initMpi(int* argc, char*** argv)
{
  if (mpiIsRunning())
    return;
  // Alone, Open MPI would spend 0.2 s looking for networks; what the user has set goes first.
  if (launchedProcesses() <= 1) {
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
  }
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
}

int mpiCount(std::size_t n)
{
  NDFRAME_ASSERT(n <= std::size_t(std::numeric_limits<int>::max()), "a message is too long for MPI");
  return int(n);
}

} // namespace

Comm Comm::world(int& argc, char**& argv)
{
  if (launchedProcesses() <= 1)
    return single();
  initMpi(&argc, &argv);
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return Comm(rank, size);
}

void Comm::sum(Vector& values) const
{
  if (size_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, values.data(), mpiCount(values.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

std::int64_t Comm::sum(std::int64_t value) const
{
  if (size_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

void Comm::broadcast(Vector& values) const
{
  if (size_ == 1)
    return;
  std::int64_t length = std::int64_t(values.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  values.resize(std::size_t(length));
  MPI_Bcast(values.data(), mpiCount(values.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

void Comm::broadcast(std::string& text) const
{
  if (size_ == 1)
    return;
  std::int64_t length = std::int64_t(text.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  text.resize(std::size_t(length));
  MPI_Bcast(text.data(), mpiCount(text.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
}

void Comm::abort(int exitCode) const
{
  if (size_ > 1)
    MPI_Abort(MPI_COMM_WORLD, exitCode);
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

void finishMpi()
{
  finishKrylov();
  if (mpiIsRunning())
    MPI_Finalize();
}

} // namespace ndframe
