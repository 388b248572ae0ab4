#pragma once

#include <mpi.h>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// For calls of MPI; a single process has itself only.
inline MPI_Comm mpiComm(const Comm& comm)
{
  return comm.size() == 1 ? MPI_COMM_SELF : MPI_Comm_f2c(comm.communicator());
}

} // namespace ndframe
