#include "mumps_instance.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "mpi_comm.hpp"

namespace ndframe
{

namespace
{

constexpr int firstJob = -1, lastJob = -2, factorJob = 2;
constexpr int positiveDefinite = 1;

/// ICNTL(14), the percentage of memory beyond the estimate: doubled from its default up to this.
constexpr int largestMemoryMargin = 2000;

struct Reason
{
  int code;
  MumpsFailure::Kind kind;
  const char* text;
};

constexpr std::array<Reason, 10> reasons = {{
    {-5, MumpsFailure::Kind::Memory, "not enough memory for the analysis"},
    {-7, MumpsFailure::Kind::Memory, "not enough memory for the analysis"},
    {-8, MumpsFailure::Kind::Workspace, "the integer workspace is too small"},
    {-9, MumpsFailure::Kind::Workspace, "the workspace is too small"},
    {-10, MumpsFailure::Kind::Singular, "the matrix is singular"},
    {-13, MumpsFailure::Kind::Memory, "not enough memory"},
    {-17, MumpsFailure::Kind::Workspace, "the send buffer is too small"},
    {-19, MumpsFailure::Kind::Memory, "not enough memory"},
    {-20, MumpsFailure::Kind::Workspace, "the receive buffer is too small"},
    {-40, MumpsFailure::Kind::Singular, "the matrix is not positive definite"},
}};

constexpr Reason unknownReason = {0, MumpsFailure::Kind::Other, "see the MUMPS manual"};

const Reason& reasonOf(int code)
{
  const auto* found = std::find_if(reasons.begin(), reasons.end(), [code](const Reason& r) { return r.code == code; });
  return found == reasons.end() ? unknownReason : *found;
}

} // namespace

MumpsFailure::MumpsFailure(int code, int detail)
    : std::runtime_error(fmt::format("MUMPS: {} (INFOG(1) = {}, INFOG(2) = {})", reasonOf(code).text, code, detail)),
      kind_(reasonOf(code).kind)
{}

MumpsInstance::MumpsInstance(const Comm& comm)
{
  startMpi();
  data_.comm_fortran = MUMPS_INT(MPI_Comm_c2f(mpiComm(comm)));
  data_.par = 1;
  data_.sym = positiveDefinite;
  run(firstJob);
  for (int stream = 1; stream <= 3; ++stream)
    icntl(stream) = -1;
  icntl(4) = 0;
}

MumpsInstance::~MumpsInstance()
{
  data_.job = lastJob;
  dmumps_c(&data_);
}

void MumpsInstance::factor()
{
  for (;;) {
    try {
      return run(factorJob);
    } catch (const MumpsFailure& failure) {
      if (failure.kind() != MumpsFailure::Kind::Workspace || icntl(14) >= largestMemoryMargin)
        throw;
      icntl(14) *= 2;
    }
  }
}

void MumpsInstance::run(int job)
{
  data_.job = job;
  dmumps_c(&data_);
  if (infog(1) < 0)
    throw MumpsFailure(infog(1), infog(2));
}

} // namespace ndframe
